// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "client/scan_record.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/sha256.h"
#include "scan_cell_common/pose/units.h"

namespace scan_cell {
namespace {

/// Record of a file read by another node, maybe on another machine.
Json file_record(const std::string& file) {
  try {
    return {{"name", file}, {"sha256", scan_cell_common::sha256_of_file(file)}};
  } catch (const scan_cell_common::FileError&) {
    return {{"name", file}, {"sha256", nullptr}};
  }
}

Json binding_of(const scan_cell_msgs::BindingAudit& audit) {
  using scan_cell_common::kMillimetres;
  constexpr double kMilliseconds = 1e3;
  return {{"pulses", audit.triggers},
          {"frames", audit.frames},
          {"bound", audit.frames_bound},
          {"dropped", audit.frames_dropped},
          {"never_arrived", audit.frames_never_arrived},
          {"worst_position_error_mm", kMillimetres * audit.worst_position_error},
          {"worst_time_to_pose_ms", kMilliseconds * audit.worst_time_to_pose}};
}

}  // namespace

void add_passes(Json& all, const scan_cell_msgs::CloudStatistics& scan) {
  if (scan.agreement_message.empty()) return;  // one sweep only
  using scan_cell_common::kDegrees;
  using scan_cell_common::kMillimetres;
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

Json to_json(const CalibrationFiles& calibration) {
  return {{"scanner", file_record(calibration.scanner)}, {"cell", file_record(calibration.cell)}};
}

void save_scan_record(const std::string& file, const scan_cell_msgs::ScanResult& scan,
                      const CalibrationFiles& calibration,
                      const std::optional<CameraRegion>& region) {
  Json all = {{"scan_id", scan.scan_id},
              {"message", scan.message},
              {"warnings", scan.warnings},
              {"scanned", scan.cloud.header.stamp.toSec()},
              {"seconds", scan.seconds},
              {"binding", binding_of(scan.audit)},
              {"calibration", to_json(calibration)},
              {"camera_region", nullptr}};
  if (region) {
    all["camera_region"] = {
        {"x", region->x}, {"y", region->y}, {"width", region->width}, {"height", region->height}};
  }
  add_passes(all, scan.statistics);
  save_json(file, all);
}

void save_json(const std::string& file, const Json& all) {
  constexpr int kIndent = 2;
  scan_cell_common::save_text(file, all.dump(kIndent) + "\n");
}

}  // namespace scan_cell
