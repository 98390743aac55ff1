// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/arm/arm.h"
#include "scan_cell_sim/controller/kinematics.h"

namespace scan_cell_sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// J2 and J3 that put the wrist's centre at a point in the plane of the arm.
/// @param forward, up [m] from axis 2
/// @param elbow 1 or -1: its direction of bending
std::optional<Eigen::Vector2d> arm_joints(double forward, double up, double elbow) {
  constexpr double kRounding = 1e-12;  // of a cosine; chosen
  const double cosine =
      (forward * forward + up * up - kA2 * kA2 - kForearm * kForearm) / (2 * kA2 * kForearm);
  if (!(std::abs(cosine) <= 1 + kRounding)) return std::nullopt;
  const double bend = elbow * std::acos(std::clamp(cosine, -1.0, 1.0));
  const double lean = std::atan2(forward, up) +
                      std::atan2(kForearm * std::sin(bend), kA2 + kForearm * std::cos(bend));
  return Eigen::Vector2d(lean, bend - kForearmAngle);
}

/// J4, J5 and J6 for a turn, with J4 as in `near` where only J4 + J6 is defined.
/// @param turn from the forearm to the last axis: Rx(-J4) Ry(J5) Rx(-J6)
/// @param side 1 or -1: of J5
Vector3d wrist_joints(const Matrix3d& turn, double side, double near) {
  constexpr double kStraight = 1e-12;  // sine of J5; chosen
  const double sine = std::hypot(turn(1, 0), turn(2, 0));
  double first = -near;
  if (sine > kStraight) first = std::atan2(side * turn(1, 0), -side * turn(2, 0));
  // what is left after J4: the second row of Rx(J4) * turn is (0, cos J6, sin J6)
  const Matrix3d rest = AngleAxisd(-first, Vector3d::UnitX()) * turn;
  const double last = std::atan2(-rest(1, 2), rest(1, 1));
  return {-first, std::atan2(side * sine, turn(0, 0)), -last};
}

/// The same posture, with each axis turned by full turns to be nearest within its range.
Joints turned_near(Joints joints, const Joints& near) {
  constexpr double kTurn = 2 * M_PI;  // [rad]
  const JointLimits& limits = joint_limits();
  for (int i = 0; i < 6; ++i) {
    joints[i] += kTurn * std::round((near[i] - joints[i]) / kTurn);
    if (joints[i] > limits.upper[i] && joints[i] - kTurn >= limits.lower[i]) joints[i] -= kTurn;
    if (joints[i] < limits.lower[i] && joints[i] + kTurn <= limits.upper[i]) joints[i] += kTurn;
  }
  return joints;
}

}  // namespace

std::vector<Joints> postures_of(const Eigen::Isometry3d& flange, const Joints& near) {
  constexpr double kOnAxis = 1e-9;  // [m] chosen
  const Matrix3d last_axis = flange_turn().transpose();
  std::vector<Joints> found;
  const Vector3d wrist = flange.translation() - kD6 * flange.linear().col(2);
  const double radius = std::hypot(wrist.x(), wrist.y());
  const double front = radius > kOnAxis ? -std::atan2(wrist.y(), wrist.x()) : near[0];
  for (const double facing : {1.0, -1.0}) {
    for (const double elbow : {1.0, -1.0}) {
      const auto arm = arm_joints(facing * radius - kA1, wrist.z() - kD1, elbow);
      if (!arm) continue;
      Joints joints = Joints::Zero();
      joints.head<3>() << (facing > 0 ? front : front + M_PI), (*arm)[0], (*arm)[1];
      const Matrix3d straight = flange_of(joints).linear() * last_axis;
      const Matrix3d turn = straight.transpose() * flange.linear() * last_axis;
      for (const double side : {1.0, -1.0}) {
        joints.tail<3>() = wrist_joints(turn, side, near[3]);
        found.push_back(turned_near(joints, near));
      }
    }
  }
  return found;
}

std::optional<Joints> joints_of(const Eigen::Isometry3d& flange, const Joints& near) {
  std::optional<Joints> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const Joints& joints : postures_of(flange, near)) {
    const double turn = (joints - near).norm();
    if (!(turn < least)) continue;
    least = turn;
    nearest = joints;
  }
  return nearest;
}

}  // namespace scan_cell_sim
