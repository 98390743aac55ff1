// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/limits.h"

#include <cmath>
#include <sstream>

#include "scan_cell_common/errors.h"

namespace c4g_driver {
namespace {

using scan_cell_common::Refused;

constexpr double kDegree = M_PI / 180;

template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

void check_between(const std::string& thing, double value, double least, double most,
                   const std::string& unit) {
  if (value >= least && value <= most) return;  // not so for NaN
  throw Refused(thing, text(value, unit), text("give one from ", least, " to ", most, unit));
}

}  // namespace

RobotLimits::RobotLimits() : workspace_min(-1.4, -1.4, 0.15), workspace_max(1.4, 1.4, 1.9) {
  joint_lower << -170, -85, -170, -210, -130, -2700;
  joint_upper << 170, 155, 0, 210, 130, 2700;
  joint_lower *= kDegree;
  joint_upper *= kDegree;
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
  for (int i = 0; i < 6; ++i) {
    check_between(text("target J", i + 1), joints[i], limits.joint_lower[i], limits.joint_upper[i],
                  " rad");
  }
  return Eigen::Map<const Joints>(joints.data());
}

void check_camera_rate(double rate, const RobotLimits& limits) {
  check_between("camera rate", rate, 0, limits.most_camera_rate, " Hz");
}

void check_linear_speed(double speed, const RobotLimits& limits) {
  constexpr double kLeast = 1e-5;  // a hundredth of a millimetre a second: the wire's least
  check_between("linear speed", speed, kLeast, limits.most_linear_speed, " m/s");
}

void check_speed_in_force(double speed, const RobotLimits& limits) {
  constexpr double kRounding = 1e-6;  // [m/s] of the way to the wire's unit and back
  if (speed <= limits.most_linear_speed + kRounding) return;
  throw Refused("linear speed set on the controller", text(speed, " m/s"),
                text("set one up to ", limits.most_linear_speed, " m/s first"));
}

void check_override(double percent) {
  constexpr double kLeast = 0.01;
  check_between("override", percent, kLeast, 100, " %");
}

}  // namespace c4g_driver
