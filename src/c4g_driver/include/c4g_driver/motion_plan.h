// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "c4g_driver/motion.h"

namespace c4g_driver {

/// A motion among several that will be carried out one after the other.
struct PlannedMotion {
  Motion motion;                       //!< as it will be asked for
  std::optional<double> linear_speed;  //!< [m/s] at which it will be run; none: as the settings say
};

/// How far the robot could get in a plan.
struct PlanCheck {
  std::vector<Joints> ends;          //!< [rad] of the first motions, all of which are possible
  std::string refusal;               //!< why the one after those is not; empty: all are possible
  std::optional<MotionPlace> place;  //!< on its way, where it fails at one place
};

/// Checks motions one after the other, each from where the one before ends, as the client checks
/// the one that it is about to send. The settings stay, but for the linear speed.
/// @param limits narrowed() to the robot
/// @param from the robot at rest, before the first
/// @throw scan_cell_common::Refused if the model does not put the flange where it was measured
PlanCheck check_plan(const RobotModel& robot, const RobotLimits& limits, const RobotState& from,
                     const MotionSettings& settings, const std::vector<PlannedMotion>& plan);

}  // namespace c4g_driver
