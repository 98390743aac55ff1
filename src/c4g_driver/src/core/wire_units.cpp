// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/wire_units.h"

#include <cmath>

namespace c4g_driver {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kMillimetre = 1e-3;

}  // namespace

EulerAngles to_euler(const Eigen::Matrix3d& rotation) {
  constexpr double kDegenerate = 1e-12;
  const double sine = std::hypot(rotation(0, 2), rotation(1, 2));
  EulerAngles angles{};
  angles.a = sine > kDegenerate ? std::atan2(rotation(1, 2), rotation(0, 2)) : 0;
  angles.e = std::atan2(sine, rotation(2, 2));
  // r is what is left after a: the second row of Rz(-a) * rotation is (sin r, cos r, 0). Taken from
  // the third row it would not fit a where the sine of e is small.
  const Eigen::RowVector3d row =
      -std::sin(angles.a) * rotation.row(0) + std::cos(angles.a) * rotation.row(1);
  angles.r = std::atan2(row.x(), row.y());
  return angles;
}

Eigen::Matrix3d from_euler(const EulerAngles& angles) {
  return (Eigen::AngleAxisd(angles.a, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(angles.e, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(angles.r, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

WireSix to_wire(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d p = pose.translation() / kMillimetre;
  const EulerAngles angles = to_euler(pose.linear());
  return {p.x(), p.y(), p.z(), angles.a / kDegree, angles.e / kDegree, angles.r / kDegree};
}

Eigen::Isometry3d pose_from_wire(const WireSix& wire) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << wire[0], wire[1], wire[2];
  pose.translation() *= kMillimetre;
  pose.linear() = from_euler({wire[3] * kDegree, wire[4] * kDegree, wire[5] * kDegree});
  return pose;
}

WireSix to_wire(const Joints& joints) {
  WireSix wire{};
  Eigen::Map<Joints>(wire.data()) = joints / kDegree;
  return wire;
}

Joints joints_from_wire(const WireSix& wire) {
  return Eigen::Map<const Joints>(wire.data()) * kDegree;
}

}  // namespace c4g_driver
