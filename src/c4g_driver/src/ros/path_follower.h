// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>
#include <scan_cell_msgs/FollowAction.h>

#include <string>

#include "c4g_driver/client.h"
#include "scan_cell_common/ros/listeners.h"

namespace c4g_driver {

/// The action ~follow: a whole tool path.
class PathFollower {
 public:
  /// @param status topic to which watchers must subscribe
  /// @param feedback_rate [Hz]
  PathFollower(ros::NodeHandle node, Client& client, const scan_cell_common::Listeners& listeners,
               const std::string& status, const std::string& base_frame, double feedback_rate);

  /// Accepts goals from here on.
  void start() { server_.start(); }

 private:
  using Server = actionlib::SimpleActionServer<scan_cell_msgs::FollowAction>;

  void follow(const scan_cell_msgs::FollowGoalConstPtr& goal);
  void begin(const scan_cell_msgs::FollowGoal& goal);
  Goal watch(const scan_cell_msgs::FollowGoal& goal);
  void publish_feedback(const Goal& goal);
  geometry_msgs::PoseStamped tip(const MeasuredState& state) const;
  void finish(const Goal& end);
  void finish(std::uint8_t outcome, const std::string& message, std::uint64_t waypoint = 0);

  Client& client_;
  const scan_cell_common::Listeners& listeners_;
  const std::string status_;
  const std::string base_frame_;
  const double feedback_rate_;
  Eigen::Isometry3d flange_to_tip_ = Eigen::Isometry3d::Identity();  // of the goal
  Server server_;  // last, since its callbacks use all other members
};

}  // namespace c4g_driver
