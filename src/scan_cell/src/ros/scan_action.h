// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/action_server.h>
#include <ros/node_handle.h>
#include <scan_cell_msgs/CellState.h>
#include <scan_cell_msgs/ScanAction.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "parameters.h"
#include "ros_devices.h"
#include "scan_cell/ros/ros_stages.h"
#include "scan_cell/scan_sequence.h"

namespace scan_cell {

/// The action ~scan and the latched topic ~state. One scan at a time: a second goal is rejected
/// with the name of the scan that runs.
class ScanAction : private ScanObserver {
 public:
  /// @param node the private node handle
  ScanAction(ros::NodeHandle node, const Parameters& parameters);

  /// Cancels the scan under way, if any, and waits until the cell is safe.
  ~ScanAction() override;

 private:
  using Server = actionlib::ActionServer<scan_cell_msgs::ScanAction>;

  void on_goal(Server::GoalHandle goal);
  void on_cancel(Server::GoalHandle goal);
  void run();
  void conclude(const ScanEnd& end, double seconds);

  /// @throw scan_cell_common::Refused
  ScanRequest request_from(const scan_cell_msgs::ScanGoal& goal) const;
  Eigen::Isometry3d in_base_frame(const geometry_msgs::PoseStamped& pose) const;

  void on_progress(int step, const std::string& name, double progress) override;
  void on_capture_begins() override;
  void on_capture_ends() override;
  void publish_state(std::uint8_t state, const std::string& message);

  const Parameters parameters_;
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_{transforms_};
  RosRobot robot_;
  RosCamera camera_;
  RosTrigger trigger_;
  RosStages stages_;
  ScanSequence sequence_;
  ros::Publisher state_publisher_;
  std::atomic<std::uint64_t> points_{0};
  ros::Subscriber cloud_subscriber_;
  ros::WallTime last_feedback_;
  int last_step_ = 0;

  std::mutex mutex_;  // of what follows
  bool running_ = false;
  bool ending_ = false;  // no goal is taken any more
  Server::GoalHandle goal_;
  std::thread thread_;
  std::atomic<bool> cancel_{false};
  ScanRequest request_;
  Server server_;  // last: its callbacks use all the rest
};

}  // namespace scan_cell
