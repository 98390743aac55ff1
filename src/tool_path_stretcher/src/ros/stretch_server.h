// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>
#include <scan_cell_msgs/StretchToolPathAction.h>

#include "report.h"
#include "tool_path_stretcher/stretch_parameters.h"

namespace tool_path_stretcher {

/// The action ~stretch and its topics for rviz.
class StretchServer {
 public:
  /// @throw scan_cell_common::InvalidParameter
  explicit StretchServer(const ros::NodeHandle& private_node);

 private:
  void execute(const scan_cell_msgs::StretchToolPathGoalConstPtr& goal);
  StretchResult run(const scan_cell_msgs::StretchToolPathGoal& goal, const ToolPath& path,
                    RunRecord& record);
  bool on_progress(const std::string& stage, double progress);
  void show_input(const scan_cell_msgs::StretchToolPathGoal& goal);
  void show_result(const StretchResult& result, const ToolPath& path,
                   const scan_cell_msgs::StretchToolPathGoal& goal);

  ros::NodeHandle node_;
  StretchParameters parameters_;
  ros::Publisher reference_;
  ros::Publisher object_;
  ros::Publisher mapped_reference_;
  ros::Publisher reference_path_;
  ros::Publisher adapted_path_;
  ros::Publisher markers_;
  actionlib::SimpleActionServer<scan_cell_msgs::StretchToolPathAction> server_;
};

}  // namespace tool_path_stretcher
