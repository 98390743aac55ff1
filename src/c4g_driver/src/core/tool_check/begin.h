// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "tool_check/judge/judge.h"

namespace c4g_driver {

/// Whether the robot stands at the path's first waypoint, as near as a goal is reached.
bool stands_at_begin(const ToolCheckSubject& subject, const RobotState& from);

/// The same with any turn about the tool's z: that turn [rad] of the first waypoint's pose.
std::optional<double> turn_at_begin(const ToolCheckSubject& subject, const RobotState& from);

/// Joints [rad] to begin with, a posture each, first the one that the robot gets to soonest. Those
/// outside the ranges come last, since they are no use unless the tool turns.
/// @param turn [rad] of the first waypoint's pose about the tool's z
std::vector<Joints> begins(const ToolCheckSubject& subject, const RobotState& from, double turn);

/// How many of begins() are within the ranges.
std::size_t count_within(const ToolCheckSubject& subject, const std::vector<Joints>& begins);

}  // namespace c4g_driver
