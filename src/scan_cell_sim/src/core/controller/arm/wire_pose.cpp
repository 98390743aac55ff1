// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/arm/wire_pose.h"

#include <cmath>
#include <kdl/frames.hpp>

#include "scan_cell_common/pose/units.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::kDegree;
using scan_cell_common::kMillimetre;

/// [deg] in -180 < angle <= 180
double turned(double angle) {
  const double rest = std::remainder(angle, 360.0);
  return rest <= -180 ? 180 : rest;
}

/// @param steps in a unit
double rounded(double value, double steps) {
  return std::round(value * steps) / steps + 0.0;  // never -0
}

}  // namespace

WireSix to_wire(const Eigen::Isometry3d& pose) {
  const auto& m = pose.linear();
  const KDL::Rotation rotation(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0),
                               m(2, 1), m(2, 2));
  double a = 0;
  double e = 0;
  double r = 0;
  rotation.GetEulerZYZ(a, e, r);
  constexpr double kStraight = 1e-6;  // [rad] closer to 0 or 180 degrees KDL returns exactly these
  if (e < kStraight || e > M_PI - kStraight) {
    r = e < kStraight ? a + r : r - a;
    a = 0;
  }
  const Eigen::Vector3d p = pose.translation() / kMillimetre;
  return {p.x(), p.y(), p.z(), turned(a / kDegree), e / kDegree, turned(r / kDegree)};
}

WireSix shown(const Eigen::Isometry3d& pose) {
  constexpr double kSteps[] = {1000, 1000, 1000, 10000, 10000, 10000};  // [1/mm], [1/deg] chosen
  WireSix wire = to_wire(pose);
  for (std::size_t i = 0; i < 6; ++i)
    wire[i] = rounded(wire[i], kSteps[i]);
  wire[3] = turned(wire[3]);
  wire[5] = turned(wire[5]);
  return wire;
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

WireSix shown(const Joints& joints) {
  constexpr double kSteps = 10000;  // [1/deg] chosen
  WireSix wire = to_wire(joints);
  for (double& angle : wire)
    angle = rounded(angle, kSteps);
  return wire;
}

Joints joints_from_wire(const WireSix& wire) {
  Joints joints;
  for (int i = 0; i < 6; ++i)
    joints[i] = wire[i] * kDegree;
  return joints;
}

}  // namespace scan_cell_sim
