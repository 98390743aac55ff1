// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/WorkPreview.h>

#include <QString>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace scan_cell_rviz {

/// Range of a joint [rad].
struct JointLimits {
  double lower = 0;
  double upper = 0;
};

/// Ranges of a robot's joints.
struct RobotLimits {
  std::map<std::string, JointLimits> of_robot;  ///< by name; joints without limits are missing
  /// [rad] Parameters joint_lower and joint_upper of its driver, in the preview's order of joints;
  /// empty: not given. They can only narrow a range.
  std::vector<double> lower, upper;
};

/// Limits in a robot_description; empty if the text is no URDF.
std::map<std::string, JointLimits> limits_in(const std::string& urdf);

/// How a joint turns along a path.
struct JointTurn {
  std::string joint;
  std::size_t place = 0;  ///< index among the preview's joints
  double from = 0;        ///< [rad] end of the range reached first
  double to = 0;          ///< [rad] the other end
};

/// The joint that turns most along the path itself, without the ways to it and away from it. On a
/// closed path a joint may go on by a turn with each round.
/// @return none if fewer than two poses of the path are reached
std::optional<JointTurn> most_turned(const scan_cell_msgs::WorkPreview& preview);

/// Text for a person, in degrees, with the joint's range if known.
QString text_of(const JointTurn& turn, const RobotLimits& limits);

}  // namespace scan_cell_rviz
