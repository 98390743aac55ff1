// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/PreviewWork.h>

#include "devices/ros_devices.h"
#include "devices/work_planner.h"

namespace scan_cell {

/// The service ~preview_work, and the topic ~work_preview for displays: where the tip and the
/// joints would move, how fast, and where they cannot. Nothing moves.
class PreviewWork {
 public:
  /// @param base_frame of the robot
  PreviewWork(ros::NodeHandle node, const std::string& base_frame, const WorkPlanner& planner,
              const RosRobot& robot);

 private:
  bool serve(scan_cell_msgs::PreviewWork::Request& request,
             scan_cell_msgs::PreviewWork::Response& response);

  const std::string base_frame_;
  const WorkPlanner& planner_;
  const RosRobot& robot_;
  ros::Publisher shown_;
  ros::ServiceServer server_;
};

}  // namespace scan_cell
