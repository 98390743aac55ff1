// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Path.h>
#include <scan_cell_msgs/ToolPath.h>

#include "tool_path_stretcher/tool_path.h"

namespace tool_path_stretcher {

/// @throw scan_cell_common::UnusableInput naming a waypoint that is not finite or whose orientation
/// is not a unit quaternion
ToolPath from_message(const scan_cell_msgs::ToolPath& message);

scan_cell_msgs::ToolPath to_message(const ToolPath& path, const std_msgs::Header& header);

/// All segments one after the other, for rviz.
nav_msgs::Path to_path_message(const ToolPath& path, const std_msgs::Header& header);

}  // namespace tool_path_stretcher
