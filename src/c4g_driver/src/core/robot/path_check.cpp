// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/path_check.h"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "robot/inverse_kinematics.h"

namespace c4g_driver {
namespace {

constexpr double kRounding = 1e-6;  // [rad] or [m] beyond a limit; chosen
constexpr const char* kOtherWay = "use a joint motion, or intermediate points";

std::optional<Hindrance> outside_range(const Joints& joints, const RobotLimits& limits,
                                       const std::string& path, double way) {
  for (int i = 0; i < 6; ++i) {
    const double lower = limits.joint_lower[i], upper = limits.joint_upper[i];
    if (joints[i] >= lower - kRounding && joints[i] <= upper + kRounding) continue;
    return Hindrance{
        fmt::format("{}, J{}", path, i + 1), fmt::format("{:g} rad at {}", joints[i], at(way)),
        fmt::format("its range is {}: {}", range(lower, upper, " rad"), kOtherWay), way};
  }
  return std::nullopt;
}

std::optional<Hindrance> singular(const RobotModel& robot, const Joints& before,
                                  const Joints& joints, const std::string& path, double way) {
  const std::string tied = singular_joints(robot.jacobian_at(joints));
  if (!tied.empty()) {
    return Hindrance{path, "passes a singular posture of " + tied + " at " + at(way), kOtherWay,
                     way};
  }
  int joint = 0;
  const double jump = (joints - before).cwiseAbs().maxCoeff(&joint);
  if (jump <= kTurnsOver) return std::nullopt;
  return Hindrance{fmt::format("{}, J{}", path, joint + 1),
                   fmt::format("turns over by {:g} rad at {}", jump, at(way)), kOtherWay, way};
}

Hindrance lost(const std::string& path, double way) {
  return {path, "the robot cannot follow it in this posture from " + at(way), kOtherWay, way};
}

void take(Strain& strain, const RobotModel& robot, const Joints& rate, double way) {
  int joint = 0;
  const double share = rate.cwiseQuotient(robot.speed()).maxCoeff(&joint);
  if (share > strain.share) strain = {share, joint, rate[joint], way};
}

}  // namespace

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

double steps_along(const Path::Stretch& stretch) {
  constexpr double kStepLength = 0.005;  // [m] chosen
  constexpr double kStepAngle = 0.0175;  // [rad] one degree; chosen
  return std::ceil(std::max({1.0, stretch.length / kStepLength, stretch.angle / kStepAngle}) -
                   kRounding);
}

PathCheck follow(const RobotModel& robot, const RobotLimits& limits, const Path& path,
                 const Joints& joints, double seconds) {
  PathCheck check;
  const auto start = step_to(robot, path.at(0), joints);
  if (!start) return {lost(path.name(), 0), {}, joints};
  Joints before = *start;
  for (const Path::Stretch& stretch : path.stretches()) {
    const double share = stretch.end - stretch.begin;
    const double steps = steps_along(stretch);
    for (double step = 1; step <= steps; ++step) {
      const double way = stretch.begin + share * step / steps;
      const Eigen::Isometry3d flange = path.at(way);
      const auto next = step_to(robot, flange, before);
      if (!next) return {lost(path.name(), way), check.strain, before};
      auto& found = check.hindrance;
      found = outside_workspace(flange.translation(), limits, kRounding, way);
      if (!found) found = outside_range(*next, limits, path.name(), way);
      if (!found) found = singular(robot, before, *next, path.name(), way);
      if (found) return check;
      take(check.strain, robot, (*next - before).cwiseAbs() * steps / (share * seconds), way);
      before = *next;
    }
  }
  check.joints = before;
  return check;
}

std::optional<Hindrance> outside_workspace(const Eigen::Vector3d& place, const RobotLimits& limits,
                                           double slack, double way) {
  for (int i = 0; i < 3; ++i) {
    const double lower = limits.workspace_min[i], upper = limits.workspace_max[i];
    if (place[i] >= lower - slack && place[i] <= upper + slack) continue;
    return Hindrance{
        fmt::format("way of the flange, {}", "xyz"[i]),
        fmt::format("{:g} m at {}", place[i], at(way)),
        fmt::format("the workspace is {}: use intermediate points", range(lower, upper, " m")),
        way};
  }
  return std::nullopt;
}

std::string at(double way) {
  return fmt::format("{} % of the way", std::lround(100 * way));
}

std::string range(double lower, double upper, const char* unit) {
  return fmt::format("{:g} .. {:g}{}", lower, upper, unit);
}

}  // namespace c4g_driver
