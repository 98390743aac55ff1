// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motion_check.h"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "robot/inverse_kinematics.h"
#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {

using scan_cell_common::Refused;

struct MotionCheck::Strain {
  double share = 0;  // of the joint's own speed, at full override
  int joint = 0;
  double rate = 0;  // [rad/s]
  double way = 0;
};

namespace {

constexpr double kRounding = 1e-6;  // [%] of the override; chosen
constexpr const char* kOtherWay = "go there in joints, or by points between";

std::string at(double way) {
  return fmt::format("{} % of the way", std::lround(100 * way));
}

std::string range(double lower, double upper, const char* unit) {
  return fmt::format("{:g} .. {:g}{}", lower, upper, unit);
}

/// [%] at which a speed that is `share` of the most at full override keeps to it.
double max_override(double share) {
  return share > 1 ? 100 / share : 100;
}

/// The joints that a singular posture ties together, or nothing.
std::string singular_joints(const RobotModel::Jacobian& jacobian) {
  constexpr double kSingular = 0.01;  // of a wrist: axes 4 and 6 within a degree
  constexpr double kTakesPart = 0.3;  // of a unit vector over the joints; chosen
  const Eigen::JacobiSVD<RobotModel::Jacobian> svd(jacobian, Eigen::ComputeFullV);
  if (svd.singularValues()[5] > kSingular) return "";
  const Joints tied = svd.matrixV().col(5).cwiseAbs();
  std::string names;
  for (int i = 0; i < 6; ++i) {
    if (tied[i] > kTakesPart) names += fmt::format("{}{}", names.empty() ? "J" : " and J", i + 1);
  }
  return names;
}

void check_model(const RobotModel& robot, const RobotState& from) {
  constexpr double kPosition = 0.01;  // [m] a nominal arm is within a few millimetres
  constexpr double kAngle = 0.02;     // [rad] chosen
  const auto off = twist(robot.flange_at(from.joints), from.flange);
  if (off.head<3>().norm() <= kPosition && off.tail<3>().norm() <= kAngle) return;
  throw Refused(
      "robot description",
      fmt::format("places the flange {:g} m and {:g} rad from where the controller says it is",
                  off.head<3>().norm(), off.tail<3>().norm()),
      "give the URDF of this robot, with the controller's signs and zeros of the joints");
}

}  // namespace

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

double MotionCheck::to_pose(const Eigen::Isometry3d& target) const {
  if (settings_.in_joints) return to_joints(reach(target));
  check_speed_in_force(settings_.linear_speed, speed_);
  const Line line(from_.flange, target, settings_.euler);
  Strain strain;
  if (const auto found = follow(line, strain)) {
    reach(target);  // where the target itself is at fault, that is what to say
    throw Refused(found->thing, found->value, found->cure);
  }
  const double most = max_override(strain.share);
  if (settings_.override <= most + kRounding) return most;
  throw Refused(
      fmt::format("speed of J{}", strain.joint + 1),
      fmt::format("{:g} rad/s at {}", strain.rate * settings_.override / 100, at(strain.way)),
      fmt::format("the limit is {:g} rad/s: set the override up to {:g} %, or lower speeds",
                  robot_.speed()[strain.joint], most));
}

/// Steps along the line with the posture the robot is in.
/// @return what stands in the way
std::optional<MotionCheck::Hindrance> MotionCheck::follow(const Line& line, Strain& strain) const {
  constexpr double kStepLength = 0.005;  // [m] chosen
  constexpr double kStepAngle = 0.0175;  // [rad] one degree; chosen
  const double steps = std::ceil(
      std::max({1.0, line.length() / kStepLength, line.angle() / kStepAngle}) - kRounding);
  const double seconds =
      std::max(line.length() / settings_.linear_speed, line.angle() / settings_.rotational_speed);
  Joints joints = from_.joints;
  for (double step = 0; step <= steps; ++step) {
    const double way = step / steps;
    const auto next = step_to(robot_, line.at(way), joints);
    if (!next) {
      return Hindrance{"line", "the posture cannot follow it from " + at(way), kOtherWay};
    }
    if (step > 0) {
      if (auto found = hindrance(joints, *next, at(way))) return found;
      const Joints rate = (*next - joints).cwiseAbs() * steps / seconds;
      int joint = 0;
      const double share = rate.cwiseQuotient(robot_.speed()).maxCoeff(&joint);
      if (share > strain.share) strain = {share, joint, rate[joint], way};
    }
    joints = *next;
  }
  return std::nullopt;
}

std::optional<MotionCheck::Hindrance> MotionCheck::hindrance(const Joints& before,
                                                             const Joints& joints,
                                                             const std::string& where) const {
  constexpr double kJump = 0.2;  // [rad] in a step of a degree; chosen
  for (int i = 0; i < 6; ++i) {
    const double lower = limits_.joint_lower[i], upper = limits_.joint_upper[i];
    if (joints[i] >= lower - kRounding && joints[i] <= upper + kRounding) continue;
    return Hindrance{fmt::format("line, J{}", i + 1),
                     fmt::format("{:g} rad at {}", joints[i], where),
                     fmt::format("its range is {}: {}", range(lower, upper, " rad"), kOtherWay)};
  }
  const std::string tied = singular_joints(robot_.jacobian_at(joints));
  if (!tied.empty()) {
    return Hindrance{"line", "passes a singular posture of " + tied + " at " + where, kOtherWay};
  }
  int joint = 0;
  const double jump = (joints - before).cwiseAbs().maxCoeff(&joint);
  if (jump > kJump) {
    return Hindrance{fmt::format("line, J{}", joint + 1),
                     fmt::format("turns over by {:g} rad at {}", jump, where), kOtherWay};
  }
  return std::nullopt;
}

/// The posture nearest to the present one, within the ranges.
Joints MotionCheck::reach(const Eigen::Isometry3d& target) const {
  const Postures postures = postures_for(robot_, target, from_.joints);
  if (postures.joints.empty()) {
    throw Refused("target", fmt::format("out of reach by {:g} m", postures.gap),
                  "give one nearer to the robot, or with another orientation");
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
    if (best[i] >= lower - kRounding && best[i] <= upper + kRounding) continue;
    throw Refused(fmt::format("target J{}", i + 1),
                  fmt::format("{:g} rad in the posture that comes nearest", best[i]),
                  "give a pose that keeps it within " + range(lower, upper, " rad"));
  }
  return best;
}

double MotionCheck::to_joints(const Joints& target) const {
  constexpr double kStep = 0.02;  // [rad] chosen
  const Joints turn = target - from_.joints;
  const double steps = std::ceil(std::max(1.0, turn.cwiseAbs().maxCoeff() / kStep));
  const double seconds = turn.cwiseAbs().cwiseQuotient(robot_.speed()).maxCoeff();
  Eigen::Vector3d place = robot_.flange_at(from_.joints).translation();
  double longest = 0;  // [m] in a step
  for (double step = 1; step <= steps; ++step) {
    const Joints joints = from_.joints + step / steps * turn;
    const Eigen::Vector3d next = robot_.flange_at(joints).translation();
    check_box(next, step / steps);
    longest = std::max(longest, (next - place).norm());
    place = next;
  }
  if (!speed_.reduced || seconds <= 0) return 100;
  const double speed = longest * steps / seconds;
  const double most = max_override(speed / speed_.most);
  if (settings_.override <= most + kRounding) return most;
  throw Refused("speed of the flange", fmt::format("{:g} m/s", speed * settings_.override / 100),
                fmt::format("the limit is {:g} m/s, set the override up to {:g} %: {}", speed_.most,
                            most, speed_.reason));
}

void MotionCheck::check_box(const Eigen::Vector3d& place, double way) const {
  constexpr double kModel = 0.01;  // [m] what the model may be off, as in check_model
  for (int i = 0; i < 3; ++i) {
    const double lower = limits_.workspace_min[i], upper = limits_.workspace_max[i];
    if (place[i] >= lower - kModel && place[i] <= upper + kModel) continue;
    throw Refused(
        fmt::format("way of the flange, {}", "xyz"[i]),
        fmt::format("{:g} m at {}", place[i], at(way)),
        fmt::format("the workspace is {}: go by points between", range(lower, upper, " m")));
  }
}

}  // namespace c4g_driver
