// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "c4g_driver/limits.h"
#include "c4g_driver/tool_check.h"
#include "c4g_driver/tool_motion.h"

namespace c4g_driver {

class CollisionScene;

/// Whether the robot can follow a path, looked at before anything moves: each waypoint, and the way
/// between in steps of 5 mm and a degree at most, along the lines and turns that the controller
/// goes. The posture stays the same all along the path: the present one if the robot stands at the
/// first waypoint and can follow the path from there, else the nearest to it of those in which the
/// path can be followed. With free_about_z the tool is turned so that the joints move least, as far
/// as posture, ranges, box and scene let it; where no such turns are found, the path is checked as
/// given.
/// @param limits narrowed() to the robot
/// @param from the robot at rest: its joints, and the mode that decides about the speed limit
/// @param scene with which nothing may collide; none: collisions are not looked for
/// @return also where all is refused; if no posture can follow, of the one in which the robot
/// stands at the first waypoint, or else that gets farthest
/// @throw scan_cell_common::UnusableInput if the path is none: less than two waypoints, numbers
/// that are not finite, a pose that is not a rotation, a speed that is not above 0
ToolCheck check_tool_motion(const RobotModel& robot, const RobotLimits& limits,
                            const RobotState& from, const ToolMotion& motion,
                            const ToolCheckParameters& parameters = {},
                            const CollisionScene* scene = nullptr);

}  // namespace c4g_driver
