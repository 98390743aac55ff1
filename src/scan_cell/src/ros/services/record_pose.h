// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/RecordPose.h>

#include "sequence/devices.h"

namespace scan_cell {

/// The service ~record_pose: a person moves the robot by its pendant, and its poses are recorded.
class RecordPose {
 public:
  /// @param base_frame of the robot's poses
  RecordPose(ros::NodeHandle node, const std::string& base_frame, Robot& robot);

 private:
  bool serve(scan_cell_msgs::RecordPose::Request& request,
             scan_cell_msgs::RecordPose::Response& response);

  const std::string base_frame_;
  Robot& robot_;
  ros::ServiceServer server_;
};

}  // namespace scan_cell
