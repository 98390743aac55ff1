// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/CellState.h>

#include <string>

#include "scan_cell_common/ros/listeners.h"

namespace scan_cell {

/// The latched topic ~state. A node that subscribes to it can watch over a goal. Thread-safe.
class StateTopic {
 public:
  /// @param node the private node handle
  explicit StateTopic(ros::NodeHandle node)
      : publisher_(listeners_.advertise<scan_cell_msgs::CellState>(node, "state", 10, true)) {}

  void publish(const scan_cell_msgs::CellState& state) const { publisher_.publish(state); }

  std::string name() const { return publisher_.getTopic(); }

  /// Whether this node is subscribed. Always true for an empty name, which means nobody.
  bool is_watched_by(const std::string& node) const {
    return node.empty() || listeners_.contains(node);
  }

  /// Waits briefly until the node is subscribed: a goal may overtake its sender's subscription.
  void wait_for(const std::string& node) const {
    constexpr double kPatience = 1, kLook = 0.01;  // [s] chosen
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
    while (!is_watched_by(node) && ros::WallTime::now() < deadline)
      ros::WallDuration(kLook).sleep();
  }

 private:
  scan_cell_common::Listeners listeners_;
  ros::Publisher publisher_;
};

}  // namespace scan_cell
