// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "tool_check/judge/judge.h"

namespace c4g_driver {

/// Whether the robot stands at the path's first waypoint, within the tolerance of a goal.
bool stands_at_begin(const ToolCheckSubject& subject, const RobotState& from);

/// The same with any turn about the tool's z; returns that turn [rad] of the first waypoint's pose.
std::optional<double> turn_at_begin(const ToolCheckSubject& subject, const RobotState& from);

/// Joints [rad] to begin with, one set per posture, the one that the robot reaches soonest first.
/// Postures outside the ranges come last: they are only useful if the tool turns.
/// @param turn [rad] of the first waypoint's pose about the tool's z
std::vector<Joints> begins(const ToolCheckSubject& subject, const RobotState& from, double turn);

/// How many of begins() are within the ranges.
std::size_t count_within(const ToolCheckSubject& subject, const std::vector<Joints>& begins);

}  // namespace c4g_driver
