// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "c4g_driver/limits.h"
#include "c4g_driver/tool_check.h"
#include "tool_check/judge/track.h"

namespace c4g_driver {

class CollisionScene;

/// What a path is judged by.
struct ToolCheckSubject {
  const RobotModel& robot;
  const RobotLimits& limits;  // narrowed() to the robot
  SpeedLimit speed;
  const ToolMotion& motion;
  const ToolCheckParameters& parameters;
  const CollisionScene* scene;  // or none
};

/// Turns joints by full turns all along the track, where their ranges ask for it.
void choose_turns(Track& track, const ToolCheckSubject& subject);

/// All that is wrong along a track, and its figures.
ToolCheck judge(const Track& track, const ToolCheckSubject& subject);

}  // namespace c4g_driver
