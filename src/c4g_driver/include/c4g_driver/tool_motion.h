// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace c4g_driver {

/// A pose to which the tool's tip moves along a line.
struct ToolWaypoint {
  Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();  //!< in base_link [m]
  double speed = 0.05;        //!< [m/s] of the tip on the way to this pose
  double zone = 0;            //!< [m] radius within which the tip may leave its lines; 0: it stops
  std::uint32_t outputs = 0;  //!< bit n: digital output n + 1 is on from here on
};

/// A whole tool path. The tip moves along a line from waypoint to waypoint, while the tool turns
/// about one fixed axis. When the path begins, the tip stands at the first waypoint.
struct ToolMotion {
  Eigen::Isometry3d flange_to_tip = Eigen::Isometry3d::Identity();  //!< [m]
  std::vector<ToolWaypoint> waypoints;                              //!< in order of motion
};

}  // namespace c4g_driver
