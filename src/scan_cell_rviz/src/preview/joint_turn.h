// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/WorkPreview.h>

#include <QString>
#include <map>
#include <optional>
#include <string>

namespace scan_cell_rviz {

/// How far a joint can turn [rad].
struct JointLimits {
  double lower = 0;
  double upper = 0;
};

/// Of the joints of a robot that have any, by name.
using RobotLimits = std::map<std::string, JointLimits>;

/// As a robot_description has them; none where the text is no URDF.
RobotLimits limits_in(const std::string& urdf);

/// How a joint turns along a path.
struct JointTurn {
  std::string joint;
  double from = 0;  ///< [rad] the end of its range that it has first
  double to = 0;    ///< [rad] the other one
};

/// The joint that turns most along the path itself, not on the way to it or away from it: over a
/// path that is closed one may go on by a turn with each round.
/// @return none where fewer than two poses of the path are reached
std::optional<JointTurn> most_turned(const scan_cell_msgs::WorkPreview& preview);

/// For a person, in degrees; with the joint's limits where they are known.
QString text_of(const JointTurn& turn, const RobotLimits& limits);

}  // namespace scan_cell_rviz
