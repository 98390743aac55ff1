// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace c4g_driver {

/// A pose that the tool's tip goes to along a line.
struct ToolWaypoint {
  Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();  //!< in base_link [m]
  double speed = 0.05;                                    //!< [m/s] of the tip on the way to here
  double zone = 0;            //!< [m] how far from here the tip may leave its lines; 0: it stops
  std::uint32_t outputs = 0;  //!< bit n: digital output n+1 is on from here on
};

/// A whole path that the robot follows: lines of the tip from waypoint to waypoint, along each of
/// which the tool turns about one fixed axis. The first waypoint is where the tip stands when the
/// path begins.
struct ToolMotion {
  Eigen::Isometry3d flange_to_tip = Eigen::Isometry3d::Identity();  //!< [m]
  std::vector<ToolWaypoint> waypoints;                              //!< in the order of the motion
};

}  // namespace c4g_driver
