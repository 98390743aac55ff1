// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/ros/adaptation_report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/sha256.h"

namespace scan_cell {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// How the passes of the scan agree.
void add_passes(Json& all, const scan_cell_msgs::CloudStatistics& scan) {
  if (scan.agreement_message.empty()) return;  // of one sweep
  constexpr double kMillimetres = 1e3;
  constexpr double kDegrees = 180 / M_PI;
  Json& passes = all["passes"];
  const char* const names[] = {"not compared", "agree", "mended", "disagree"};
  passes["agreement"] = names[std::min<std::size_t>(scan.agreement, std::size(names) - 1)];
  passes["message"] = scan.agreement_message;
  passes["overlaps"] = Json::array();
  for (const scan_cell_msgs::PassOverlap& pair : scan.overlaps) {
    passes["overlaps"].push_back({{"passes", {pair.pass_one + 1, pair.pass_other + 1}},
                                  {"lasers", {pair.laser_one, pair.laser_other}},
                                  {"places", pair.points},
                                  {"median_mm", kMillimetres * pair.median},
                                  {"within_95_percent_mm", kMillimetres * pair.most}});
  }
  passes["corrections"] = Json::array();
  for (const scan_cell_msgs::PassCorrection& each : scan.corrections) {
    const double shift = std::hypot(each.shift.x, each.shift.y, each.shift.z);
    const double turn = std::hypot(each.turn.x, each.turn.y, each.turn.z);
    passes["corrections"].push_back({{"pass", each.pass_index + 1},
                                     {"laser", each.laser},
                                     {"shift_mm", kMillimetres * shift},
                                     {"turn_degrees", kDegrees * turn}});
  }
}

Json record_of(const std::string& file, const std::string& units, const std::string& name) {
  if (file.empty()) return nullptr;
  return {{"name", name}, {"sha256", scan_cell_common::sha256_of_file(file)}, {"units", units}};
}

/// As given by its user.
Json input(const std::string& file, const std::string& units) {
  return record_of(file, units, file);
}

/// Beside the report.
Json output(const std::string& file, const std::string& units) {
  return record_of(file, units, fs::path(file).filename().string());
}

/// One that another node has read, maybe on another machine.
Json calibration(const std::string& file) {
  try {
    return {{"name", file}, {"sha256", scan_cell_common::sha256_of_file(file)}};
  } catch (const scan_cell_common::FileError&) {
    return {{"name", file}, {"sha256", nullptr}};
  }
}

}  // namespace

std::string completed(const std::string& report, const AdaptationRecord& record,
                      const scan_cell_msgs::CloudStatistics& scan) {
  Json all = Json::parse(report);
  all["files"] = {{"reference", input(record.reference, "m")},
                  {"object", output(record.object, "m")},
                  {"path", input(record.path, record.path_units)},
                  {"output", output(record.adapted, record.path_units)}};
  all["scanned"] = record.scanned;
  all["calibration"] = {{"scanner", calibration(record.calibration.scanner)},
                        {"cell", calibration(record.calibration.cell)}};
  add_passes(all, scan);
  constexpr int kIndent = 2;
  return all.dump(kIndent) + "\n";
}

}  // namespace scan_cell
