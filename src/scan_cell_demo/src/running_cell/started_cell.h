// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>
#include <vector>

#include "scan_cell_common/testing/child_process.h"

namespace scan_cell_demo {

/// A cell under its own ROS master, with this program as another node. The cell ends with this
/// object.
class StartedCell {
 public:
  /// @param name of this program's node
  /// @param launch roslaunch's file and arguments
  /// @param folder created for the logs; empty: ROS' default
  /// @throw scan_cell_common::Refused if there is no master after a minute
  StartedCell(const std::string& name, const std::vector<std::string>& launch,
              const std::string& folder);

 private:
  scan_cell_common::ChildProcess launched_;
  ros::AsyncSpinner spinner_;
};

}  // namespace scan_cell_demo
