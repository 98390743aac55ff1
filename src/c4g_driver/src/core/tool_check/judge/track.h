// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "c4g_driver/robot_model.h"
#include "c4g_driver/tool_motion.h"

namespace c4g_driver {

/// A place at which a path is checked.
struct TrackPlace {
  std::size_t waypoint;   // at it, or on the way to it
  double way;             // 0 .. 1 of the way from the waypoint before
  Eigen::Isometry3d tip;  // in base_link
  Eigen::Isometry3d flange;
  bool reached = false;
  Joints joints;           // [rad] if reached
  Joints rate;             // [rad] by the way, if reached and not singular
  double flange_rate = 0;  // [m] of the flange's origin, by the way
  double jump = 0;         // [rad] largest change of a joint since the place before
  int jumping = 0;         // that joint
  std::string tied;        // joints of a singular posture
};

/// A path as the robot follows it in one posture.
struct Track {
  std::vector<TrackPlace> places;  // first: at waypoint 0; of each way: its start and each step
};

/// Follows the path in small steps. Ignores ranges. Where the posture does not reach, goes on from
/// the next place that it reaches.
/// @param start [rad] at the first waypoint, or near it
Track track(const RobotModel& robot, const ToolMotion& motion, const Joints& start);

}  // namespace c4g_driver
