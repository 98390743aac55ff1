// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/ros/adaptation.h"

#include <filesystem>

#include "scan_cell_common/cloud_files.h"
#include "scan_cell_common/errors.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "scan_cell_common/yaml_file.h"
#include "tool_path_stretcher/ros/conversions.h"
#include "tool_path_stretcher/tool_path_files.h"

namespace scan_cell {

namespace fs = std::filesystem;

scan_cell_msgs::StretchVerdict adapt(CellClient& client, const AdaptationFiles& files,
                                     const sensor_msgs::PointCloud2& object, double timeout,
                                     const CellClient::Progress& progress) {
  scan_cell_msgs::StretchToolPathGoal goal;
  goal.reference =
      scan_cell_common::to_message(scan_cell_common::load_cloud(files.reference), object.header);
  goal.object = object;
  goal.path = tool_path_stretcher::to_message(tool_path_stretcher::load_tool_path(files.path),
                                              object.header);

  const fs::path output(files.output);
  std::error_code failure;
  fs::create_directories(output, failure);
  if (failure) {
    throw scan_cell_common::FileError(files.output, failure.message(), "give a folder of yours");
  }
  fs::remove(output / "adapted_path.csv", failure);
  scan_cell_common::save_cloud((output / "object.ply").string(),
                               scan_cell_common::from_message(object));
  const auto result = client.stretch(goal, timeout, progress);
  scan_cell_common::save_text((output / "report.json").string(), result.report);
  if (result.verdict.reason == scan_cell_msgs::StretchVerdict::ACCEPTED) {
    tool_path_stretcher::save_tool_path((output / "adapted_path.csv").string(),
                                        tool_path_stretcher::from_message(result.path));
  }
  return result.verdict;
}

}  // namespace scan_cell
