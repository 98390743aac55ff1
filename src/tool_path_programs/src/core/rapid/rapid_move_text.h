// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// "[[x,y,z],[q1,q2,q3,q4]]" of a pose [m], as RAPID writes it.
std::string rapid_pose(const Eigen::Isometry3d& pose);

/// The robtarget of a pose: configuration by quarter turns where the joints are known.
std::string rapid_robtarget(const Eigen::Isometry3d& pose,
                            const std::optional<JointAngles>& joints);

/// A speeddata: by its name where one is predefined.
/// @param speed of the tip [m/s]
/// @throw scan_cell_common::UnusableInput naming the waypoint if it cannot be said
std::string rapid_speed(double speed, double max_change, std::size_t waypoint);

/// A zonedata: by its name where one is predefined.
/// @param radius [m] 0: fine
std::string rapid_zone(double radius, std::size_t waypoint);

/// The speed of the tip that stands for all of the axes' speed [m/s].
constexpr double kRapidFullSpeed = 5;

}  // namespace tool_path_programs
