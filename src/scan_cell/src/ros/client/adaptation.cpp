// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "client/adaptation.h"

#include <filesystem>

#include "scan_cell/ros/adaptation_report.h"
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
  if (failure)
    throw FileError(files.output, failure.message(), "choose a folder that you may write to");
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
  // Writes the path before the report: an accepting report without its path would be false.
  if (result.verdict.reason == scan_cell_msgs::StretchVerdict::ACCEPTED)
    tool_paths::save_tool_path((output / kPath).string(),
                               tool_path_stretcher::from_message(result.path), path.layout);
  const bool accepted = result.verdict.reason == scan_cell_msgs::StretchVerdict::ACCEPTED;
  scan_cell_common::save_text(
      (output / kReport).string(),
      completed(result.report,
                {files.reference, files.path, path.layout.pose.units, (output / kObject).string(),
                 accepted ? (output / kPath).string() : "", object.header.stamp.toSec(),
                 client.calibration_files()},
                scan));
  return result.verdict;
}

}  // namespace scan_cell
