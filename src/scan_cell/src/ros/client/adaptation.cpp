// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "client/adaptation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/outputs.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "tool_path_stretcher/ros/conversions.h"
#include "tool_paths/tool_path_files.h"

namespace scan_cell {

namespace fs = std::filesystem;

using scan_cell_common::FileError;

namespace {

/// The stretcher's report with how the passes of the scan agree.
std::string with_passes(const std::string& report, const scan_cell_msgs::CloudStatistics& scan) {
  if (scan.agreement_message.empty()) return report;  // of one sweep
  constexpr double kMillimetres = 1e3;
  constexpr double kDegrees = 180 / M_PI;
  nlohmann::ordered_json all = nlohmann::ordered_json::parse(report);
  nlohmann::ordered_json& passes = all["passes"];
  const char* const names[] = {"not compared", "agree", "mended", "disagree"};
  passes["agreement"] = names[std::min<std::size_t>(scan.agreement, std::size(names) - 1)];
  passes["message"] = scan.agreement_message;
  passes["overlaps"] = nlohmann::ordered_json::array();
  for (const scan_cell_msgs::PassOverlap& pair : scan.overlaps) {
    passes["overlaps"].push_back({{"passes", {pair.pass_one + 1, pair.pass_other + 1}},
                                  {"lasers", {pair.laser_one, pair.laser_other}},
                                  {"places", pair.points},
                                  {"median_mm", kMillimetres * pair.median},
                                  {"within_95_percent_mm", kMillimetres * pair.most}});
  }
  passes["corrections"] = nlohmann::ordered_json::array();
  for (const scan_cell_msgs::PassCorrection& each : scan.corrections) {
    const double shift = std::hypot(each.shift.x, each.shift.y, each.shift.z);
    const double turn = std::hypot(each.turn.x, each.turn.y, each.turn.z);
    passes["corrections"].push_back({{"pass", each.pass_index + 1},
                                     {"laser", each.laser},
                                     {"shift_mm", kMillimetres * shift},
                                     {"turn_degrees", kDegrees * turn}});
  }
  constexpr int kIndent = 2;
  return all.dump(kIndent) + "\n";
}

const char* const kObject = "object.ply";
const char* const kPath = "adapted_path.csv";
const char* const kReport = "report.json";

}  // namespace

std::vector<std::string> result_names() {
  return {kObject, kPath, kReport};
}

void clear_results(const AdaptationFiles& files) {
  const fs::path output(files.output);
  std::error_code failure;
  fs::create_directories(output, failure);
  if (failure) throw FileError(files.output, failure.message(), "give a folder of yours");
  for (const std::string& name : result_names())
    scan_cell_common::refuse_overwriting(output / name, {files.reference, files.path});
  for (const std::string& name : result_names())
    scan_cell_common::remove_old(output / name);
}

scan_cell_msgs::StretchVerdict adapt(CellClient& client, const AdaptationFiles& files,
                                     const sensor_msgs::PointCloud2& object, double timeout,
                                     const CellClient::Progress& progress,
                                     const scan_cell_msgs::CloudStatistics& scan) {
  scan_cell_msgs::StretchToolPathGoal goal;
  goal.reference =
      scan_cell_common::to_message(scan_cell_common::load_cloud(files.reference), object.header);
  goal.object = object;
  const auto path = tool_paths::load_tool_path_file(files.path);
  goal.path = tool_path_stretcher::to_message(path.path, object.header);

  const fs::path output(files.output);
  scan_cell_common::save_cloud((output / kObject).string(), scan_cell_common::view_of(object));
  const auto result = client.stretch(goal, timeout, progress);
  // The path before the report: an accepting report without its path would be a lie.
  if (result.verdict.reason == scan_cell_msgs::StretchVerdict::ACCEPTED) {
    tool_paths::save_tool_path((output / kPath).string(),
                               tool_path_stretcher::from_message(result.path), path.layout);
  }
  scan_cell_common::save_text((output / kReport).string(), with_passes(result.report, scan));
  return result.verdict;
}

}  // namespace scan_cell
