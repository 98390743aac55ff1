// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// Makes sure that URScript can say a program.
/// @throw scan_cell_common::UnusableInput naming the first waypoint that it cannot say, and the
/// cure
void check_for_urscript(const Program& program, const WriteSettings& settings);

/// The variable that holds a user frame; empty: poses are in the robot's base.
std::string urscript_frame_name(const Frame& user);

/// [rad/s] of a joint move at the whole speed of the axes.
constexpr double kUrscriptJointSpeed = 3.14159265358979;

/// Digits behind the point of speeds [m/s], [rad/s] and zones [m].
constexpr int kUrscriptSpeedDigits = 6;

}  // namespace tool_path_programs
