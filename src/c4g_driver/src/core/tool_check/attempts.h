// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "tool_check/judge/judge.h"

namespace c4g_driver {

/// The path with the turns that it has: in the posture in which the robot stands at its begin, or
/// in one after the other until one can follow it. If none can, of the one that gets farthest.
ToolCheck check_as_given(const ToolCheckSubject& subject, const RobotState& from);

/// The path with the turns about the tool's z that move the joints least.
/// @return none if no turns are found with which the path can be followed
std::optional<ToolCheck> check_with_free_turn(const ToolCheckSubject& subject,
                                              const RobotState& from);

}  // namespace c4g_driver
