// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motion_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "robot/inverse_kinematics.h"
#include "robot/path_check.h"
#include "robot/paths/arc.h"
#include "robot/paths/line.h"
#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {

using scan_cell_common::Refused;

namespace {

constexpr double kBeyondSetting = 1e-6;  // [%] of the override, [rad] of a range; chosen

/// Highest override [%] that keeps the limit, for a speed that is `share` of the limit at full
/// override.
double max_override(double share) {
  return share > 1 ? 100 / share : 100;
}

[[noreturn]] void refuse(const Hindrance& found, const Eigen::Isometry3d& flange) {
  throw MotionRefused(found.thing, found.value, found.cure, {found.way, flange});
}

/// Duration [s] of the path at full override: the slowest stretch decides the speed of the whole
/// path.
double duration(const Path& path, const MotionSettings& settings) {
  double longest = 0;
  for (const Path::Stretch& stretch : path.stretches()) {
    const double seconds =
        std::max(stretch.length / settings.linear_speed, stretch.angle / settings.rotational_speed);
    longest = std::max(longest, seconds / (stretch.end - stretch.begin));
  }
  return longest;
}

}  // namespace

void check_goal(const Motion& motion, const RobotModel& robot, const RobotLimits& limits) {
  if (motion.kind == Motion::Kind::kToJoints) {
    check_workspace(robot.flange_at(check_joints(motion.joints, limits)), limits);
  } else {
    if (motion.kind == Motion::Kind::kAlongArc) check_flange(motion.via, limits, "via");
    check_flange(motion.flange, limits);
  }
  check_camera_rate(motion.camera_rate, limits);
}

void check_model(const RobotModel& robot, const RobotState& state) {
  constexpr double kPosition = 0.01;  // [m] a nominal arm is within a few millimetres
  constexpr double kAngle = 0.02;     // [rad] chosen
  const auto off = twist(robot.flange_at(state.joints), state.flange);
  if (off.head<3>().norm() <= kPosition && off.tail<3>().norm() <= kAngle) return;
  throw Refused(
      "robot description",
      fmt::format("places the flange {:g} m and {:g} rad from where the controller says it is",
                  off.head<3>().norm(), off.tail<3>().norm()),
      "give the URDF of this robot, with the controller's signs and zeros of the joints");
}

MotionCheck::MotionCheck(const RobotModel& robot, const RobotLimits& limits, const RobotState& from,
                         const MotionSettings& settings)
    : robot_(robot),
      from_(from),
      settings_(settings),
      limits_(limits),
      speed_(speed_limit(limits, &from)) {
  check_model(robot, from);
  limits_.joint_lower = limits.joint_lower.cwiseMin(from.joints);
  limits_.joint_upper = limits.joint_upper.cwiseMax(from.joints);
  limits_.workspace_min = limits.workspace_min.cwiseMin(from.flange.translation());
  limits_.workspace_max = limits.workspace_max.cwiseMax(from.flange.translation());
}

MotionEnd MotionCheck::run(const Motion& motion) const {
  switch (motion.kind) {
    case Motion::Kind::kToPose:
      return to_pose(motion.flange);
    case Motion::Kind::kAlongArc:
      return along_arc(motion.via, motion.flange);
    case Motion::Kind::kToJoints:
      break;
  }
  return to_joints(Eigen::Map<const Joints>(motion.joints.data()));
}

MotionEnd MotionCheck::to_pose(const Eigen::Isometry3d& target) const {
  if (settings_.in_joints) return to_joints(reach({1, target}, "target"));
  return along(Line(from_.flange, target, settings_.euler));
}

MotionEnd MotionCheck::along_arc(const Eigen::Isometry3d& via,
                                 const Eigen::Isometry3d& target) const {
  return along(Arc(from_.flange, via, target));
}

MotionEnd MotionCheck::along(const Path& path) const {
  check_speed_in_force(settings_.linear_speed, speed_);
  const auto [hindrance, strain, joints] =
      follow(robot_, limits_, path, from_.joints, duration(path, settings_));
  if (hindrance) {
    for (const Path::Stretch& stretch : path.stretches())
      reach({stretch.end, path.at(stretch.end)}, stretch.target);  // its fault comes first
    refuse(*hindrance, path.at(hindrance->way));
  }
  const double most = max_override(strain.share);
  if (settings_.override <= most + kBeyondSetting) return {most, joints, path.at(1)};
  throw MotionRefused(
      fmt::format("speed of J{}", strain.joint + 1),
      fmt::format("{:g} rad/s at {}", strain.rate * settings_.override / 100, at(strain.way)),
      fmt::format(
          "the limit is {:g} rad/s: set the override to {:g} % or less, or lower the speeds",
          robot_.speed()[strain.joint], most),
      {strain.way, path.at(strain.way)});
}

/// The posture within the ranges that is nearest to the present one.
/// @param name of the target
Joints MotionCheck::reach(const MotionPlace& target, const std::string& name) const {
  const Postures postures = postures_for(robot_, target.flange, from_.joints);
  if (postures.joints.empty()) {
    throw MotionRefused(name, fmt::format("out of reach by {:g} m", postures.gap),
                        "give one nearer to the robot, or with another orientation", target);
  }
  const auto cost = [this](const Joints& joints) {
    constexpr double kRangesFirst = 1e3;  // weight above any angle [rad]; chosen
    return kRangesFirst * excess(joints, limits_.joint_lower, limits_.joint_upper) +
           (joints - from_.joints).norm();
  };
  const Joints best =
      *std::min_element(postures.joints.begin(), postures.joints.end(),
                        [&](const Joints& a, const Joints& b) { return cost(a) < cost(b); });
  for (int i = 0; i < 6; ++i) {
    const double lower = limits_.joint_lower[i], upper = limits_.joint_upper[i];
    if (best[i] >= lower - kBeyondSetting && best[i] <= upper + kBeyondSetting) continue;
    throw MotionRefused(fmt::format("{} J{}", name, i + 1),
                        fmt::format("{:g} rad in the nearest posture", best[i]),
                        "give a pose that keeps it within " + range(lower, upper, " rad"), target);
  }
  return best;
}

MotionEnd MotionCheck::to_joints(const Joints& target) const {
  constexpr double kStep = 0.02;   // [rad] chosen
  constexpr double kModel = 0.01;  // [m] tolerated error of the model, as in check_model
  const Joints turn = target - from_.joints;
  const double steps = std::ceil(std::max(1.0, turn.cwiseAbs().maxCoeff() / kStep));
  const double seconds = turn.cwiseAbs().cwiseQuotient(robot_.speed()).maxCoeff();
  Eigen::Vector3d place = robot_.flange_at(from_.joints).translation();
  double longest = 0;  // [m] in a step
  for (double step = 1; step <= steps; ++step) {
    const Joints joints = from_.joints + step / steps * turn;
    const Eigen::Isometry3d flange = robot_.flange_at(joints);
    const Eigen::Vector3d next = flange.translation();
    const auto found = outside_workspace(next, limits_, kModel, step / steps);
    if (found) refuse(*found, flange);
    longest = std::max(longest, (next - place).norm());
    place = next;
  }
  const Eigen::Isometry3d end = robot_.flange_at(target);
  if (!speed_.reduced || seconds <= 0) return {100, target, end};
  const double speed = longest * steps / seconds;
  const double most = max_override(speed / speed_.most);
  if (settings_.override <= most + kBeyondSetting) return {most, target, end};
  throw Refused("speed of the flange", fmt::format("{:g} m/s", speed * settings_.override / 100),
                fmt::format("the limit is {:g} m/s, set the override to {:g} % or less: {}",
                            speed_.most, most, speed_.reason));
}

}  // namespace c4g_driver
