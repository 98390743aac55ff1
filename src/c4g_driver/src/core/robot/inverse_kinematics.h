// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "c4g_driver/robot_model.h"

namespace c4g_driver {

/// Joints [rad] that put the flange there to a nanometre and a nanoradian, in the posture of
/// `near`; for steps of a few degrees. Ignores ranges.
/// @return none if the posture does not lead there
std::optional<Joints> step_to(const RobotModel& robot, const Eigen::Isometry3d& flange,
                              const Joints& near);

/// All postures found for a pose, from `near` and from starts spread over the ranges.
/// Deterministic.
struct Postures {
  std::vector<Joints> joints;  //!< [rad] shifted by full turns to come nearest to `near`
  double gap = 0;  //!< [m] if there are none: distance of the nearest flange from the pose
};
Postures postures_for(const RobotModel& robot, const Eigen::Isometry3d& flange, const Joints& near);

/// Distance [m] from a pose to the nearest flange found from some joints. Ignores ranges.
/// @param joints [rad] start of the search; set to its end
double gap_from(const RobotModel& robot, const Eigen::Isometry3d& flange, Joints& joints);

/// How far a posture is outside the ranges [rad], summed over the joints.
double excess(const Joints& joints, const Joints& lower, const Joints& upper);

}  // namespace c4g_driver
