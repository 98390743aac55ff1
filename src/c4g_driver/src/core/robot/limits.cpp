// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/limits.h"

#include <algorithm>

#include "robot/text.h"
#include "scan_cell_common/errors.h"

namespace c4g_driver {
namespace {

using scan_cell_common::Refused;

void check_between(const std::string& thing, double value, double least, double most,
                   const std::string& unit) {
  if (value >= least && value <= most) return;  // not so for NaN
  throw Refused(thing, text(value, unit), text("give one from ", least, " to ", most, unit));
}

}  // namespace

RobotLimits narrowed(const RobotLimits& limits, const RobotModel& robot) {
  RobotLimits result = limits;
  result.joint_lower = limits.joint_lower.cwiseMax(robot.lower());
  result.joint_upper = limits.joint_upper.cwiseMin(robot.upper());
  for (int i = 0; i < 3; ++i) {
    if (limits.workspace_min[i] < limits.workspace_max[i]) continue;
    throw scan_cell_common::InvalidParameter(
        text("workspace, ", "xyz"[i]),
        text(limits.workspace_min[i], " .. ", limits.workspace_max[i], " m"),
        "give a lower end below the upper one");
  }
  for (int i = 0; i < 6; ++i) {
    if (result.joint_lower[i] < result.joint_upper[i]) continue;
    throw scan_cell_common::InvalidParameter(
        text("range of J", i + 1),
        text(limits.joint_lower[i], " .. ", limits.joint_upper[i], " rad"),
        text("give one within the robot's, ", robot.lower()[i], " .. ", robot.upper()[i], " rad"));
  }
  return result;
}

SpeedLimit speed_limit(const RobotLimits& limits, const RobotState* state) {
  constexpr double kReduced = 0.25;  // [m/s]
  const std::string own = "the driver's parameter most_linear_speed";
  const bool programming = state != nullptr && state->mode == ControllerMode::Programming;
  if (limits.operation == Operation::Automatic && !programming) {
    return {limits.most_linear_speed, false, own};
  }
  if (limits.most_linear_speed <= kReduced) return {limits.most_linear_speed, true, own};
  return {kReduced, true,
          programming ? "the controller is in mode programming"
                      : "people may be near, the driver's parameter operation is manual"};
}

void check_workspace(const Eigen::Isometry3d& flange, const RobotLimits& limits) {
  for (int i = 0; i < 3; ++i) {
    check_between(text("target ", "xyz"[i]), flange.translation()[i], limits.workspace_min[i],
                  limits.workspace_max[i], " m");
  }
}

void check_flange(const Eigen::Isometry3d& flange, const RobotLimits& limits) {
  constexpr double kRotation = 1e-6;
  check_workspace(flange, limits);
  const Eigen::Matrix3d& rotation = flange.linear();
  const double off = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (!(off < kRotation) || !(rotation.determinant() > 0)) {
    throw Refused("target orientation", "not a rotation", "give a unit quaternion");
  }
}

Joints check_joints(const std::vector<double>& joints, const RobotLimits& limits) {
  if (joints.size() != 6) {
    throw Refused("target joints", text(joints.size(), " values"), "give six");
  }
  constexpr double kRounding = 1e-9;  // [rad] of the ends of a range, given in degrees
  for (int i = 0; i < 6; ++i) {
    const double lower = limits.joint_lower[i], upper = limits.joint_upper[i];
    if (joints[i] >= lower - kRounding && joints[i] <= upper + kRounding) continue;
    check_between(text("target J", i + 1), joints[i], lower, upper, " rad");
  }
  return Eigen::Map<const Joints>(joints.data());
}

void check_camera_rate(double rate, const RobotLimits& limits) {
  check_between("camera rate", rate, 0, limits.most_camera_rate, " Hz");
}

void check_linear_speed(double speed, const SpeedLimit& limit) {
  constexpr double kLeast = 1e-5;  // a hundredth of a millimetre a second: the wire's least
  if (speed >= kLeast && speed <= limit.most) return;
  throw Refused("linear speed", text(speed, " m/s"),
                text("give one from ", kLeast, " to ", limit.most, " m/s: ", limit.reason));
}

void check_speed_in_force(double speed, const SpeedLimit& limit) {
  constexpr double kRounding = 1e-6;  // [m/s] of the way to the wire's unit and back
  if (speed <= limit.most + kRounding) return;
  throw Refused("linear speed set on the controller", text(speed, " m/s"),
                text("set one up to ", limit.most, " m/s first: ", limit.reason));
}

void check_override(double percent, double most) {
  constexpr double kLeast = 0.01;
  if (percent >= kLeast && percent <= most) return;
  throw Refused("override", text(percent, " %"),
                text("give one from ", kLeast, " to ", most, " %",
                     most < 100 ? "; more when the motion under way has ended" : ""));
}

}  // namespace c4g_driver
