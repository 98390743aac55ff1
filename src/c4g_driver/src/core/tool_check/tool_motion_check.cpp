// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/tool_motion_check.h"

#include <fmt/format.h>

#include <cmath>

#include "robot/motion_check.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"
#include "tool_check/attempts.h"
#include "tool_check/judge/findings.h"

namespace c4g_driver {
namespace {

using scan_cell_common::UnusableInput;

void check_pose(const Eigen::Isometry3d& pose, const std::string& name) {
  constexpr double kRotation = 1e-6;  // deviation from orthonormal, as for a goal's target
  if (!pose.translation().allFinite())
    throw UnusableInput(name, "a position that is not finite", "give numbers");
  const Eigen::Matrix3d& rotation = pose.linear();
  const double off = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (!(off < kRotation) || !(rotation.determinant() > 0))
    throw UnusableInput(name + ", orientation", "not a rotation", "give a unit quaternion");
}

void check_input(const ToolMotion& motion) {
  if (motion.waypoints.size() < 2) {
    throw UnusableInput("tool path", fmt::format("{} waypoints", motion.waypoints.size()),
                        "give two or more: the first is where the tip stands at the beginning");
  }
  check_pose(motion.flange_to_tip, "flange_to_tip");
  for (std::size_t i = 0; i < motion.waypoints.size(); ++i) {
    const ToolWaypoint& waypoint = motion.waypoints[i];
    const std::string name = place_name(i, 1);
    check_pose(waypoint.tip, name);
    if (!(waypoint.speed > 0) || !std::isfinite(waypoint.speed)) {
      throw UnusableInput(name + ", speed", fmt::format("{:g} m/s", waypoint.speed),
                          "give one above 0");
    }
    if (!(waypoint.zone >= 0) || !std::isfinite(waypoint.zone)) {
      throw UnusableInput(name + ", zone", fmt::format("{:g} m", waypoint.zone),
                          "give 0 m or more");
    }
  }
}

void check_margin(const RobotLimits& limits, double margin) {
  for (int joint = 0; joint < 6; ++joint) {
    const double range = limits.joint_upper[joint] - limits.joint_lower[joint];
    if (range > 2 * margin) continue;
    throw scan_cell_common::InvalidParameter(
        "joint_margin", fmt::format("{:g} rad", margin),
        fmt::format("give less than {:g}: half the range of J{}", range / 2, joint + 1));
  }
}

}  // namespace

ToolCheck check_tool_motion(const RobotModel& robot, const RobotLimits& limits,
                            const RobotState& from, const ToolMotion& motion,
                            const ToolCheckParameters& parameters, const CollisionScene* scene) {
  scan_cell_common::check(parameters);
  check_input(motion);
  check_margin(limits, parameters.joint_margin);
  check_model(robot, from);
  const ToolCheckSubject subject = {robot,  limits,     speed_limit(limits, &from),
                                    motion, parameters, scene};
  if (parameters.free_about_z) {
    if (auto check = check_with_free_turn(subject, from)) return std::move(*check);
  }
  return check_as_given(subject, from);
}

}  // namespace c4g_driver
