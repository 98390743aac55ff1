// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>
#include <vector>

#include "scan_cell_common/child_process.h"

namespace scan_cell_demo {

/// A cell under a ROS master of its own, and this program as a node beside it. Ends with this
/// object.
class StartedCell {
 public:
  /// @param name of this program's node
  /// @param launch what roslaunch is told: file and arguments
  /// @param folder that is made for the logs; empty: where ROS leaves them
  /// @throw scan_cell_common::Refused if there is no master after a minute
  StartedCell(const std::string& name, const std::vector<std::string>& launch,
              const std::string& folder);

 private:
  scan_cell_common::ChildProcess launched_;
  ros::AsyncSpinner spinner_;
};

}  // namespace scan_cell_demo
