// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// "[[x,y,z],[q1,q2,q3,q4]]" of a pose [m], as RAPID writes it.
std::string rapid_pose(const Eigen::Isometry3d& pose);

/// The robtarget of a pose, with configuration (quarter turns) if the joints are known.
std::string rapid_robtarget(const Eigen::Isometry3d& pose,
                            const std::optional<JointAngles>& joints);

/// A speeddata, by name if it is predefined.
/// @param speed of the tip [m/s]
/// @throw scan_cell_common::UnusableInput naming the waypoint if RAPID cannot express it
std::string rapid_speed(double speed, double max_change, std::size_t waypoint);

/// A zonedata, by name if it is predefined.
/// @param radius [m] 0: fine
std::string rapid_zone(double radius, std::size_t waypoint);

/// Tip speed written for the full speed of the axes [m/s].
constexpr double kRapidFullSpeed = 5;

}  // namespace tool_path_programs
