// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/wire_units.h"

#include <cmath>

#include "scan_cell_common/euler_angles.h"

namespace c4g_driver {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kMillimetre = 1e-3;

const scan_cell_common::EulerSequence& euler_sequence() {
  static const scan_cell_common::EulerSequence sequence("zyz");
  return sequence;
}

}  // namespace

EulerAngles to_euler(const Eigen::Matrix3d& rotation) {
  const Eigen::Vector3d angles = euler_sequence().angles(rotation);
  return {angles[0], angles[1], angles[2]};
}

Eigen::Matrix3d from_euler(const EulerAngles& angles) {
  return euler_sequence().rotation({angles.a, angles.e, angles.r});
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
