// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/arm/line_path.h"

#include <cmath>

#include "scan_cell_common/pose/timed_pose.h"

namespace scan_cell_sim {
namespace {

double nearest_turn(double from, double to) {
  return from + std::remainder(to - from, 360.0);
}

}  // namespace

LinePath::LinePath(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, bool euler)
    : from_(from), to_(to), euler_(euler), wire_from_(to_wire(from)), wire_to_(to_wire(to)) {
  for (int i = 3; i < 6; ++i)
    wire_to_[i] = nearest_turn(wire_from_[i], wire_to_[i]);
}

Eigen::Isometry3d LinePath::flange(double way) const {
  if (!euler_) return scan_cell_common::interpolate(from_, to_, way);
  WireSix wire{};
  for (int i = 0; i < 6; ++i)
    wire[i] = wire_from_[i] + way * (wire_to_[i] - wire_from_[i]);
  return pose_from_wire(wire);
}

std::vector<FlangePath::Stretch> LinePath::stretches() const {
  if (!euler_) {
    const double turn = Eigen::AngleAxisd(from_.linear().transpose() * to_.linear()).angle();
    return {{1, turn, turn}};
  }
  const Eigen::Vector3d degrees(wire_to_[3] - wire_from_[3], wire_to_[4] - wire_from_[4],
                                wire_to_[5] - wire_from_[5]);
  const Eigen::Vector3d changes = degrees.cwiseAbs() * M_PI / 180;
  return {{1, changes.maxCoeff(), changes.sum()}};
}

}  // namespace scan_cell_sim
