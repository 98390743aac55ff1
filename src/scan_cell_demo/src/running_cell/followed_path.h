// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <scan_cell_msgs/FollowAction.h>
#include <scan_cell_msgs/ToolOutputs.h>

#include <Eigen/Geometry>
#include <deque>
#include <mutex>
#include <vector>

#include "scan_cell_common/pose/timed_pose.h"
#include "scan_cell_common/ros/goal_client.h"

namespace scan_cell_demo {

/// A tool path followed by the driver of a running simulated cell, with the simulator's ground
/// truth of how it ended. Callbacks must be served by another thread (ros::AsyncSpinner).
class FollowedPath {
 public:
  using Nanoseconds = scan_cell_common::Nanoseconds;

  /// @param line two poses of the flange in base_link; the path goes to and fro between them
  FollowedPath(ros::NodeHandle node, const std::vector<Eigen::Isometry3d>& line);

  /// Sends the path, with an output on throughout. It begins at the flange's present pose.
  /// @throw scan_cell_common::Error if the driver is not there, or has no pose
  void start();

  /// Waits until `share` (0 .. 1) of the path is done.
  /// @throw EndedBefore if the path ends earlier
  void wait_for_share(double share);

  void cancel() { client_.cancel(); }

  /// Waits for the path's end.
  /// @return null if the driver died, and the result with it
  scan_cell_msgs::FollowResultConstPtr end();

  /// How the robot stopped, by the ground truth.
  struct Rest {
    double outputs_on = 0;  //!< [s] after the instant, until no output was on
    double moving = 0;      //!< [s] after the instant, until the flange stood still
  };
  /// Waits for a message of the simulator after that instant with all outputs off.
  /// @param struck host time of the instant
  /// @throw scan_cell_common::Refused if none comes within a minute
  Rest rest(Nanoseconds struck) const;

  /// Whether an output is on now in the simulator, and how often one was switched on.
  bool is_on() const;
  int switched_on() const;

 private:
  struct Place {
    Nanoseconds time;
    Eigen::Vector3d place;  // [m] of the flange in base_link
  };

  scan_cell_msgs::FollowGoal goal(const Eigen::Isometry3d& from) const;
  void on_flange(const geometry_msgs::PoseStamped& flange);
  void on_outputs(const scan_cell_msgs::ToolOutputs& outputs);

  ros::NodeHandle node_;
  const std::vector<Eigen::Isometry3d> line_;
  mutable std::mutex mutex_;
  double progress_ = 0;            // 0 .. 1
  bool on_ = false;                // an output is on
  int switched_on_ = 0;            // number of times
  Nanoseconds off_since_ = 0;      // host time
  Nanoseconds outputs_heard_ = 0;  // host time
  std::deque<Place> places_;       // since start()
  scan_cell_common::GoalClient<scan_cell_msgs::FollowAction> client_;
  ros::Subscriber flange_;
  ros::Subscriber outputs_;
};

}  // namespace scan_cell_demo
