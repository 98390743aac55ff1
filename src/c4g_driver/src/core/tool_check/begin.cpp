// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/begin.h"

#include <algorithm>
#include <cmath>

#include "robot/inverse_kinematics.h"
#include "tool_check/spin/spin_nodes.h"

namespace c4g_driver {
namespace {

constexpr double kPosition = 1e-3;  // [m] the tolerance of a goal
constexpr double kAngle = 5e-3;     // [rad]

bool within(const ToolCheckSubject& subject, const Joints& joints) {
  return excess(joints, subject.limits.joint_lower, subject.limits.joint_upper) <= 0;
}

}  // namespace

bool stands_at_begin(const ToolCheckSubject& subject, const RobotState& from) {
  const ToolMotion& motion = subject.motion;
  const auto off =
      twist(from.flange, motion.waypoints.front().tip * motion.flange_to_tip.inverse());
  return off.head<3>().norm() <= kPosition && off.tail<3>().norm() <= kAngle;
}

std::optional<double> turn_at_begin(const ToolCheckSubject& subject, const RobotState& from) {
  const Eigen::Isometry3d off =
      subject.motion.waypoints.front().tip.inverse() * from.flange * subject.motion.flange_to_tip;
  const Eigen::Vector3d axis = off.linear().col(2);
  if (off.translation().norm() > kPosition) return std::nullopt;
  if (std::atan2(axis.head<2>().norm(), axis.z()) > kAngle) return std::nullopt;
  return std::atan2(off.linear()(1, 0) - off.linear()(0, 1),
                    off.linear()(0, 0) + off.linear()(1, 1));
}

std::vector<Joints> begins(const ToolCheckSubject& subject, const RobotState& from, double turn) {
  const ToolMotion& motion = subject.motion;
  const Eigen::Isometry3d flange =
      spun(motion.waypoints.front().tip, turn) * motion.flange_to_tip.inverse();
  std::vector<Joints> found = postures_for(subject.robot, flange, from.joints).joints;
  const auto order = [&](const Joints& joints) {
    const Joints way = (joints - from.joints).cwiseAbs();
    return std::pair(!within(subject, joints), way.cwiseQuotient(subject.robot.speed()).maxCoeff());
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Joints& a, const Joints& b) { return order(a) < order(b); });
  return found;
}

std::size_t count_within(const ToolCheckSubject& subject, const std::vector<Joints>& begins) {
  return static_cast<std::size_t>(std::count_if(
      begins.begin(), begins.end(), [&](const Joints& joints) { return within(subject, joints); }));
}

}  // namespace c4g_driver
