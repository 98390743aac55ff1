// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/WorkPreview.h>

#include <cmath>

namespace scan_cell_rviz {

/// Of a robot with two joints and a path of three waypoints between an approach and a retract: the
/// last pose is out of reach.
inline scan_cell_msgs::WorkPreview made_preview() {
  scan_cell_msgs::WorkPreview preview;
  preview.header.frame_id = "base_link";
  preview.path = "/runs/run_1/adapted_path.csv";
  preview.joint_names = {"J1", "J2"};
  preview.path_waypoints = {-1, 0, 1, 2, -1};
  for (int i = 0; i < 5; ++i) {
    scan_cell_msgs::FollowWaypoint waypoint;
    waypoint.tip.position.x = 0.1 * i;
    waypoint.tip.orientation.w = 1;
    waypoint.speed = 0.01 * (i + 1);
    waypoint.outputs = i == 2 ? 5 : 0;
    preview.waypoints.push_back(waypoint);
    preview.joints.insert(preview.joints.end(), {0.1 * i, -0.2 * i});
  }
  preview.joints[9] = std::nan("");
  preview.slowest_speed = std::nan("");
  scan_cell_msgs::FollowFault fault;
  fault.waypoint = 4;
  fault.way = 1;
  fault.tip = preview.waypoints.back().tip;
  fault.message = "waypoint 4: out of reach by 0.1 m; move the part nearer to the robot";
  preview.faults = {fault};
  preview.message = fault.message;
  return preview;
}

}  // namespace scan_cell_rviz
