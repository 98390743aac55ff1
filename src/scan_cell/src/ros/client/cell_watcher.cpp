// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/ros/cell_watcher.h"

#include <ros/this_node.h>
#include <scan_cell_msgs/CellState.h>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {

CellWatcher::CellWatcher(ros::NodeHandle node, const std::string& state) {
  const boost::function<void(const scan_cell_msgs::CellStateConstPtr&)> nothing =
      [](const scan_cell_msgs::CellStateConstPtr&) {};
  state_ = node.subscribe<scan_cell_msgs::CellState>(state, 1, nothing);
}

std::string CellWatcher::name(double timeout) const {
  constexpr double kLook = 0.01;  // [s] chosen
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  while (state_.getNumPublishers() == 0) {
    if (ros::WallTime::now() > deadline) {
      throw scan_cell_common::ConnectionError(state_.getTopic(), "nobody publishes it",
                                              "is scan_cell_node running?");
    }
    ros::WallDuration(kLook).sleep();
  }
  return ros::this_node::getName();
}

}  // namespace scan_cell
