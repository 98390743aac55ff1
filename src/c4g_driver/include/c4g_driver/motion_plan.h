// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "c4g_driver/motion.h"

namespace c4g_driver {

/// One of several motions to be carried out one after the other.
struct PlannedMotion {
  Motion motion;                       //!< as it will be requested
  std::optional<double> linear_speed;  //!< [m/s] of this motion; none: that of the settings
};

/// How far the robot can get in a plan.
struct PlanCheck {
  std::vector<Joints> ends;  //!< [rad] end of each motion before the first impossible one
  std::string refusal;       //!< why the next motion is not possible; empty: all are possible
  std::optional<MotionPlace> place;  //!< where that motion fails, if at one place
};

/// Checks motions one after the other, each from the end of the one before, as the client checks a
/// motion before sending it. All settings but the linear speed stay the same.
/// @param limits narrowed() to the robot
/// @param from the robot at rest, before the first motion
/// @throw scan_cell_common::Refused if the model does not put the flange where the controller
/// measured it
PlanCheck check_plan(const RobotModel& robot, const RobotLimits& limits, const RobotState& from,
                     const MotionSettings& settings, const std::vector<PlannedMotion>& plan);

}  // namespace c4g_driver
