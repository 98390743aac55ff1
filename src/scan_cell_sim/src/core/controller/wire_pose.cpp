// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/wire_pose.h"

#include <kdl/frames.hpp>

namespace scan_cell_sim {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kMillimetre = 1e-3;

}  // namespace

WireSix to_wire(const Eigen::Isometry3d& pose) {
  const auto& m = pose.linear();
  const KDL::Rotation rotation(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0),
                               m(2, 1), m(2, 2));
  double a = 0;
  double e = 0;
  double r = 0;
  rotation.GetEulerZYZ(a, e, r);
  const Eigen::Vector3d& p = pose.translation();
  return {p.x() / kMillimetre, p.y() / kMillimetre, p.z() / kMillimetre,
          a / kDegree,         e / kDegree,         r / kDegree};
}

Eigen::Isometry3d pose_from_wire(const WireSix& wire) {
  const KDL::Rotation rotation =
      KDL::Rotation::EulerZYZ(wire[3] * kDegree, wire[4] * kDegree, wire[5] * kDegree);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    pose.translation()[row] = wire[row] * kMillimetre;
    for (int column = 0; column < 3; ++column)
      pose.linear()(row, column) = rotation(row, column);
  }
  return pose;
}

WireSix to_wire(const Joints& joints) {
  WireSix wire{};
  for (int i = 0; i < 6; ++i)
    wire[i] = joints[i] / kDegree;
  return wire;
}

Joints joints_from_wire(const WireSix& wire) {
  Joints joints;
  for (int i = 0; i < 6; ++i)
    joints[i] = wire[i] * kDegree;
  return joints;
}

}  // namespace scan_cell_sim
