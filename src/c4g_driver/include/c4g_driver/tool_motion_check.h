// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "c4g_driver/limits.h"
#include "c4g_driver/tool_check.h"
#include "c4g_driver/tool_motion.h"

namespace c4g_driver {

class CollisionScene;

/// Checks whether the robot can follow a path before anything moves: at each waypoint, and in
/// between in steps of at most 5 mm and one degree along the lines and turns of the controller. The
/// posture stays the same along the whole path: the present one if the robot stands at the first
/// waypoint and can follow the path from there, else the nearest one in which the path can be
/// followed. With free_about_z the tool is turned so that the joints move least while posture,
/// ranges, box and scene are respected; if no such turns are found, the path is checked as given.
/// @param limits narrowed() to the robot
/// @param from the robot at rest: its joints, and the mode that determines the speed limit
/// @param scene the robot must not collide with it; none: collisions are not checked
/// @return a result even if the path is refused. If no posture can follow the path, it is for the
/// posture in which the robot stands at the first waypoint, or else for the one that gets farthest
/// @throw scan_cell_common::UnusableInput if the path is invalid: fewer than two waypoints, numbers
/// that are not finite, a pose that is not a rotation, a speed that is not above 0
ToolCheck check_tool_motion(const RobotModel& robot, const RobotLimits& limits,
                            const RobotState& from, const ToolMotion& motion,
                            const ToolCheckParameters& parameters = {},
                            const CollisionScene* scene = nullptr);

}  // namespace c4g_driver
