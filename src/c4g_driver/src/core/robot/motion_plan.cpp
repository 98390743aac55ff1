// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/motion_plan.h"

#include "robot/motion_check.h"

namespace c4g_driver {
namespace {

using scan_cell_common::Refused;

MotionEnd check_next(const RobotModel& robot, const RobotLimits& limits, const RobotState& from,
                     MotionSettings settings, const PlannedMotion& planned) {
  check_goal(planned.motion, robot, limits);
  if (planned.linear_speed) {
    check_linear_speed(*planned.linear_speed, speed_limit(limits, &from));
    settings.linear_speed = *planned.linear_speed;
  }
  return MotionCheck(robot, limits, from, settings).run(planned.motion);
}

}  // namespace

PlanCheck check_plan(const RobotModel& robot, const RobotLimits& limits, const RobotState& from,
                     const MotionSettings& settings, const std::vector<PlannedMotion>& plan) {
  check_model(robot, from);
  PlanCheck check;
  RobotState state = from;
  try {
    for (const PlannedMotion& planned : plan) {
      const MotionEnd end = check_next(robot, limits, state, settings, planned);
      state.joints = end.joints;
      state.flange = end.flange;
      check.ends.push_back(end.joints);
    }
  } catch (const MotionRefused& refused) {
    check.refusal = refused.what();
    check.place = refused.place();
  } catch (const Refused& refused) {
    check.refusal = refused.what();
  }
  return check;
}

}  // namespace c4g_driver
