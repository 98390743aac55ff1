// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "tool_check/judge/judge.h"

namespace c4g_driver {

/// Checks the path with its own turns: in the robot's posture if it stands at the start, then in
/// one posture after the other until one can follow the path. If none can, the result is for the
/// robot's posture, or for the one that gets farthest if the robot does not stand there.
ToolCheck check_as_given(const ToolCheckSubject& subject, const RobotState& from);

/// Checks the path with the turns about the tool's z that move the joints least.
/// @return none if no turns are found that make the path possible
std::optional<ToolCheck> check_with_free_turn(const ToolCheckSubject& subject,
                                              const RobotState& from);

}  // namespace c4g_driver
