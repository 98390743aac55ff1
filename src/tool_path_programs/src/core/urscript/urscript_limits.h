// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// Checks that URScript can express a program.
/// @throw scan_cell_common::UnusableInput naming the first waypoint that it cannot express, and the
/// cure
void check_for_urscript(const Program& program, const WriteSettings& settings);

/// The variable that holds a user frame; empty: poses are in the robot's base.
std::string urscript_frame_name(const Frame& user);

/// [rad/s] speed of a joint move at the full speed of the axes.
constexpr double kUrscriptJointSpeed = 3.14159265358979;

/// Decimals of speeds [m/s], [rad/s] and zones [m].
constexpr int kUrscriptSpeedDigits = 6;

}  // namespace tool_path_programs
