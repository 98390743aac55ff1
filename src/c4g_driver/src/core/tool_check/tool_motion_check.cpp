// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/tool_motion_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "robot/inverse_kinematics.h"
#include "robot/motion_check.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"
#include "tool_check/findings.h"
#include "tool_check/judge.h"

namespace c4g_driver {
namespace {

using scan_cell_common::UnusableInput;

void check_pose(const Eigen::Isometry3d& pose, const std::string& name) {
  constexpr double kRotation = 1e-6;  // off orthonormal, as of a goal's target
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
                          "give one from 0 up");
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

bool stands_at(const RobotState& from, const Eigen::Isometry3d& flange) {
  constexpr double kPosition = 1e-3;  // [m] as a goal is reached
  constexpr double kAngle = 5e-3;     // [rad]
  const auto off = twist(from.flange, flange);
  return off.head<3>().norm() <= kPosition && off.tail<3>().norm() <= kAngle;
}

/// Postures to begin with, first the one that the robot gets to soonest. Those outside the ranges
/// are no use, unless there are no others.
std::vector<Joints> starts(const RobotModel& robot, const RobotLimits& limits,
                           const RobotState& from, const Eigen::Isometry3d& flange) {
  std::vector<Joints> found = postures_for(robot, flange, from.joints).joints;
  const auto outside = std::stable_partition(found.begin(), found.end(), [&](const Joints& joints) {
    return excess(joints, limits.joint_lower, limits.joint_upper) <= 0;
  });
  if (outside != found.begin()) found.erase(outside, found.end());
  if (found.empty()) return {from.joints};
  const auto seconds = [&](const Joints& joints) {
    return (joints - from.joints).cwiseAbs().cwiseQuotient(robot.speed()).maxCoeff();
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Joints& a, const Joints& b) { return seconds(a) < seconds(b); });
  return found;
}

/// Where the first fault is, in waypoints from the beginning.
double got_to(const ToolCheck& check) {
  const ToolFault& fault = check.faults.front();
  return static_cast<double>(fault.waypoint) + fault.way;
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, ToolCheckParameters& parameters) {
  table.add("joint_margin", parameters.joint_margin, {0, 1, "rad"},
            "that each joint keeps from the ends of its range");
  table.add("rotational_speed", parameters.rotational_speed, {1e-3, 10, "rad/s"},
            "of the tool, where it turns more than it moves");
}

std::string ToolCheck::refusal() const {
  return possible() ? "" : faults.front().what();
}

ToolCheck check_tool_motion(const RobotModel& robot, const RobotLimits& limits,
                            const RobotState& from, const ToolMotion& motion,
                            const ToolCheckParameters& parameters, const CollisionScene* scene) {
  scan_cell_common::check(parameters);
  check_input(motion);
  check_margin(limits, parameters.joint_margin);
  check_model(robot, from);
  const ToolCheckSubject subject = {robot,  limits,     speed_limit(limits, &from),
                                    motion, parameters, scene};
  const Eigen::Isometry3d first = motion.waypoints.front().tip * motion.flange_to_tip.inverse();
  if (stands_at(from, first)) {
    ToolCheck check = judge(track(robot, motion, from.joints), subject);
    check.stands_there = true;
    return check;
  }
  std::optional<ToolCheck> best;
  for (const Joints& start : starts(robot, limits, from, first)) {
    Track followed = track(robot, motion, start);
    choose_turns(followed, subject);
    ToolCheck check = judge(followed, subject);
    if (check.possible()) return check;
    if (!best || got_to(check) > got_to(*best)) best = std::move(check);
  }
  return *best;
}

}  // namespace c4g_driver
