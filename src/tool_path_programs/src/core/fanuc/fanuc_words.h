// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "tool_path_programs/program.h"

namespace tool_path_programs {

/// A speed as "50mm/sec", in whichever of mm/sec, cm/min and inch/min fits it best.
/// @param speed [m/s]
/// @param waypoint for the error
/// @throw scan_cell_common::UnusableInput if every unit changes it by more than max_change
std::string fanuc_speed(double speed, double max_change, std::size_t waypoint);

/// "10%" of the axes' own speed.
/// @throw scan_cell_common::UnusableInput as fanuc_speed()
std::string fanuc_share(double share, double max_change, std::size_t waypoint);

/// "FINE", "CNT100" or "CR2".
/// @param zone [m]
/// @throw scan_cell_common::UnusableInput if a corner region is not a whole number of mm
std::string fanuc_zone(double zone, bool corner_regions, std::size_t waypoint);

/// An entry of /POS.
/// @param user and tool numbers of the frames
std::string fanuc_position(std::size_t index, const Eigen::Isometry3d& pose,
                           const std::optional<JointAngles>& joints, int user, int tool);

/// An entry of /POS with joint angles [degree].
/// @throw scan_cell_common::UnusableInput if one has more than three decimals
std::string fanuc_joint_position(std::size_t index, const std::vector<double>& joints, int user,
                                 int tool);

/// @throw scan_cell_common::UnusableInput naming a valid name
void check_fanuc_name(const std::string& name, std::size_t longest);

/// A frame's number.
/// @throw scan_cell_common::UnusableInput if it is not 0 to `most`, or 0 with a pose of its own
int fanuc_frame_number(const Frame& frame, const std::string& thing, int most);

}  // namespace tool_path_programs
