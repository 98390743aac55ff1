// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "c4g_driver/robot_model.h"

namespace c4g_driver {

/// Joints [rad] that put the flange there to a nanometre and a nanoradian, in the posture that
/// `near` is in; for steps of a few degrees. Ranges are not regarded.
/// @return none where the posture does not lead there
std::optional<Joints> step_to(const RobotModel& robot, const Eigen::Isometry3d& flange,
                              const Joints& near);

/// All postures found for a pose, from `near` and from starts spread over the ranges; the same ones
/// each time.
struct Postures {
  std::vector<Joints> joints;  //!< [rad] full turns added or taken off to come nearest to `near`
  double gap = 0;              //!< [m] where there are none: what the nearest flange is short by
};
Postures postures_for(const RobotModel& robot, const Eigen::Isometry3d& flange, const Joints& near);

/// How far the flange stays from a pose [m], begun at some joints and not regarding ranges.
/// @param joints [rad] where it begins; becomes where it ends
double gap_from(const RobotModel& robot, const Eigen::Isometry3d& flange, Joints& joints);

/// How much a posture is outside the ranges [rad], summed over the joints.
double excess(const Joints& joints, const Joints& lower, const Joints& upper);

}  // namespace c4g_driver
