// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "c4g_driver/robot_model.h"
#include "c4g_driver/tool_motion.h"

namespace c4g_driver {

/// A place at which a path is looked at.
struct TrackPlace {
  std::size_t waypoint;   // at it, or on the way to it
  double way;             // 0 .. 1 of the way from the waypoint before
  Eigen::Isometry3d tip;  // in base_link
  Eigen::Isometry3d flange;
  bool reached = false;
  Joints joints;           // [rad] if reached
  Joints rate;             // [rad] by the way, if reached and not singular
  double flange_rate = 0;  // [m] of the flange's origin, by the way
  double jump = 0;         // [rad] by which a joint changed since the place before
  int jumping = 0;         // that joint
  std::string tied;        // joints of a singular posture
};

/// A path as one posture of the robot follows it.
struct Track {
  std::vector<TrackPlace> places;  // the first: at waypoint 0; of each way: its begin and each step
};

/// Follows the path in small steps. Ranges are not regarded. Where the posture does not get, it
/// goes on from the next place that it gets to.
/// @param start [rad] at the first waypoint, or near
Track track(const RobotModel& robot, const ToolMotion& motion, const Joints& start);

}  // namespace c4g_driver
