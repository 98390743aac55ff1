// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/ros/adaptation_report.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "client/scan_record.h"
#include "scan_cell_common/files/sha256.h"

namespace scan_cell {
namespace {

namespace fs = std::filesystem;

Json record_of(const std::string& file, const std::string& units, const std::string& name) {
  if (file.empty()) return nullptr;
  return {{"name", name}, {"sha256", scan_cell_common::sha256_of_file(file)}, {"units", units}};
}

/// An input file, named as given by the user.
Json input(const std::string& file, const std::string& units) {
  return record_of(file, units, file);
}

/// An output file, in the folder of the report.
Json output(const std::string& file, const std::string& units) {
  return record_of(file, units, fs::path(file).filename().string());
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
  all["calibration"] = to_json(record.calibration);
  add_passes(all, scan);
  constexpr int kIndent = 2;
  return all.dump(kIndent) + "\n";
}

}  // namespace scan_cell
