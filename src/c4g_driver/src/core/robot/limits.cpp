// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/limits.h"

#include <fmt/format.h>

#include <algorithm>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace c4g_driver {
namespace {

using scan_cell_common::Also;
using scan_cell_common::ParameterTable;
using scan_cell_common::Refused;

void check_between(const std::string& thing, double value, double least, double most,
                   const std::string& unit) {
  if (value >= least && value <= most) return;  // false for NaN
  throw Refused(thing, fmt::format("{:g}{}", value, unit),
                fmt::format("give one from {:g} to {:g}{}", least, most, unit));
}

}  // namespace

void describe(ParameterTable& table, RobotLimits& limits) {
  table.choice("operation", limits.operation, {"manual", "automatic"},
               "manual: people may be near, 250 mm/s at most; automatic: the cell is fenced");
  table.add("workspace_min", limits.workspace_min, {-10, 10, "m"},
            "box in the base frame that the flange stays in");
  table.add("workspace_max", limits.workspace_max, {-10, 10, "m"}, "the same");
  constexpr Also kNone = Also::kNone;
  table.add("joint_lower", limits.joint_lower, {-100, 100, "rad", kNone},
            "narrower than the URDF's; wider limits have no effect");
  table.add("joint_upper", limits.joint_upper, {-100, 100, "rad", kNone}, "the same");
  table.add("max_linear_speed", limits.max_linear_speed, {1e-4, 10, "m/s"},
            "along lines in automatic operation");
  table.renamed("most_linear_speed", "max_linear_speed");
  table.add("max_camera_rate", limits.max_camera_rate, {0, 1e5, "Hz"},
            "highest that a goal may request");
  table.renamed("most_camera_rate", "max_camera_rate");
}

RobotLimits narrowed(const RobotLimits& limits, const RobotModel& robot) {
  RobotLimits result = limits;
  result.joint_lower = limits.joint_lower.cwiseMax(robot.lower());
  result.joint_upper = limits.joint_upper.cwiseMin(robot.upper());
  for (int i = 0; i < 3; ++i) {
    if (limits.workspace_min[i] < limits.workspace_max[i]) continue;
    throw scan_cell_common::InvalidParameter(
        fmt::format("workspace, {}", "xyz"[i]),
        fmt::format("{:g} .. {:g} m", limits.workspace_min[i], limits.workspace_max[i]),
        "give a lower end below the upper one");
  }
  for (int i = 0; i < 6; ++i) {
    if (result.joint_lower[i] < result.joint_upper[i]) continue;
    throw scan_cell_common::InvalidParameter(
        fmt::format("range of J{}", i + 1),
        fmt::format("{:g} .. {:g} rad", limits.joint_lower[i], limits.joint_upper[i]),
        fmt::format("give a range within the robot's, {:g} .. {:g} rad", robot.lower()[i],
                    robot.upper()[i]));
  }
  return result;
}

SpeedLimit speed_limit(const RobotLimits& limits, const RobotState* state) {
  constexpr double kReduced = 0.25;  // [m/s] ISO 10218-1
  const std::string own = "the driver's parameter max_linear_speed";
  const bool programming = state != nullptr && state->mode == ControllerMode::kProgramming;
  if (limits.operation == Operation::kAutomatic && !programming) {
    return {limits.max_linear_speed, false, own};
  }
  if (limits.max_linear_speed <= kReduced) return {limits.max_linear_speed, true, own};
  return {kReduced, true,
          programming ? "the controller is in mode programming"
                      : "people may be near, the driver's parameter operation is manual"};
}

void check_workspace(const Eigen::Isometry3d& flange, const RobotLimits& limits,
                     const std::string& name) {
  for (int i = 0; i < 3; ++i) {
    check_between(fmt::format("{} {}", name, "xyz"[i]), flange.translation()[i],
                  limits.workspace_min[i], limits.workspace_max[i], " m");
  }
}

void check_flange(const Eigen::Isometry3d& flange, const RobotLimits& limits,
                  const std::string& name) {
  constexpr double kRotation = 1e-6;  // deviation from orthonormal; chosen
  check_workspace(flange, limits, name);
  const Eigen::Matrix3d& rotation = flange.linear();
  const double off = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (!(off < kRotation) || !(rotation.determinant() > 0)) {
    throw Refused(name + " orientation", "not a rotation", "give a unit quaternion");
  }
}

Joints check_joints(const std::vector<double>& joints, const RobotLimits& limits) {
  if (joints.size() != 6) {
    throw Refused("target joints", fmt::format("{} values", joints.size()), "give six");
  }
  constexpr double kRounding = 1e-9;  // [rad] of the ends of a range, given in degrees
  for (int i = 0; i < 6; ++i) {
    const double lower = limits.joint_lower[i], upper = limits.joint_upper[i];
    if (joints[i] >= lower - kRounding && joints[i] <= upper + kRounding) continue;
    check_between(fmt::format("target J{}", i + 1), joints[i], lower, upper, " rad");
  }
  return Eigen::Map<const Joints>(joints.data());
}

void check_camera_rate(double rate, const RobotLimits& limits) {
  check_between("camera rate", rate, 0, limits.max_camera_rate, " Hz");
}

void check_linear_speed(double speed, const SpeedLimit& limit) {
  constexpr double kLeast = 1e-5;  // a hundredth of a millimetre a second: the wire's least
  if (speed >= kLeast && speed <= limit.most) return;
  throw Refused(
      "linear speed", fmt::format("{:g} m/s", speed),
      fmt::format("give one from {:g} to {:g} m/s: {}", kLeast, limit.most, limit.reason));
}

void check_speed_in_force(double speed, const SpeedLimit& limit) {
  constexpr double kRounding = 1e-6;  // [m/s] of the conversion to the wire's unit and back
  if (speed <= limit.most + kRounding) return;
  throw Refused("linear speed set on the controller", fmt::format("{:g} m/s", speed),
                fmt::format("first set {:g} m/s or less: {}", limit.most, limit.reason));
}

void check_override(double percent, double most) {
  constexpr double kLeast = 0.01;  // [%] the smallest on the wire (c4g_protocol.md)
  if (percent >= kLeast && percent <= most) return;
  throw Refused(
      "override", fmt::format("{:g} %", percent),
      fmt::format("give one from {:g} to {:g} %{}", kLeast, most,
                  most < 100 ? "; a higher one only after the motion under way has ended" : ""));
}

}  // namespace c4g_driver
