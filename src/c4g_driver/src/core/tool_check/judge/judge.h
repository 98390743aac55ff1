// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "c4g_driver/limits.h"
#include "c4g_driver/tool_check.h"
#include "tool_check/judge/track.h"

namespace c4g_driver {

class CollisionScene;

/// A path and what it is judged by.
struct ToolCheckSubject {
  const RobotModel& robot;
  const RobotLimits& limits;  // narrowed() to the robot
  SpeedLimit speed;
  const ToolMotion& motion;
  const ToolCheckParameters& parameters;
  const CollisionScene* scene;  // or none
};

/// Shifts joints by full turns along the whole track where their ranges require it.
void choose_turns(Track& track, const ToolCheckSubject& subject);

/// All faults along a track, and its figures.
ToolCheck judge(const Track& track, const ToolCheckSubject& subject);

}  // namespace c4g_driver
