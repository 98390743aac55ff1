// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Path.h>
#include <trajectory_msgs/JointTrajectory.h>

#include <array>
#include <string>
#include <vector>

#include "tool_path_programs/program.h"

namespace tool_path_programs {

/// When each move of a program ends [s]; the first ends at 0. Moves run at their own speeds, or at
/// `rotational_speed` [rad/s] if the turn of the tool takes longer. Braking and fly-by are not
/// included.
std::vector<double> times_of(const Program& program, double rotational_speed);

/// The poses of all moves.
/// @param frame of the poses
nav_msgs::Path path_message(const Program& program, const std::string& frame,
                            const std::vector<double>& times);

/// The joints of all moves.
/// @param program whose moves have joints
/// @param names of the joints
trajectory_msgs::JointTrajectory trajectory_message(const Program& program,
                                                    const std::array<std::string, 6>& names,
                                                    const std::vector<double>& times);

}  // namespace tool_path_programs
