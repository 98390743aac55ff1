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

/// How far a joint can turn [rad].
struct JointLimits {
  double lower = 0;
  double upper = 0;
};

/// Of the joints of a robot.
struct RobotLimits {
  std::map<std::string, JointLimits> of_robot;  ///< those that have any, by name
  /// [rad] Parameters joint_lower and joint_upper of its driver, in the order in which a preview
  /// has the joints; empty: not given. They only make a range narrower.
  std::vector<double> lower, upper;
};

/// As a robot_description has them; none where the text is no URDF.
std::map<std::string, JointLimits> limits_in(const std::string& urdf);

/// How a joint turns along a path.
struct JointTurn {
  std::string joint;
  std::size_t place = 0;  ///< of the joint among those of the preview
  double from = 0;        ///< [rad] the end of its range that it has first
  double to = 0;          ///< [rad] the other one
};

/// The joint that turns most along the path itself, not on the way to it or away from it: over a
/// path that is closed one may go on by a turn with each round.
/// @return none where fewer than two poses of the path are reached
std::optional<JointTurn> most_turned(const scan_cell_msgs::WorkPreview& preview);

/// For a person, in degrees; with the range that the joint has where it is known.
QString text_of(const JointTurn& turn, const RobotLimits& limits);

}  // namespace scan_cell_rviz
