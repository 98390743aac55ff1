// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/paths/line.h"

#include <cmath>

#include "scan_cell_common/pose/timed_pose.h"
#include "scan_cell_common/pose/wire_pose.h"

namespace c4g_driver {
namespace {

using scan_cell_common::comau_angles;

/// Difference between two angles, the shorter way round [rad].
double shorter_way(double from, double to) {
  return std::remainder(to - from, 2 * M_PI);
}

}  // namespace

Line::Line(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, bool euler)
    : from_(from), to_(to), euler_(euler), angles_(comau_angles().angles(from.linear())) {
  const Eigen::Vector3d end = comau_angles().angles(to.linear());
  for (Eigen::Index i = 0; i < 3; ++i)
    change_[i] = shorter_way(angles_[i], end[i]);
}

Eigen::Isometry3d Line::at(double way) const {
  Eigen::Isometry3d pose = scan_cell_common::interpolate(from_, to_, way);
  if (euler_) {
    pose.linear() = comau_angles().rotation(angles_ + way * change_);
  }
  return pose;
}

std::vector<Path::Stretch> Line::stretches() const {
  const double turn = Eigen::AngleAxisd(from_.linear().transpose() * to_.linear()).angle();
  const double angle = euler_ ? change_.cwiseAbs().maxCoeff() : turn;
  return {{0, 1, (to_.translation() - from_.translation()).norm(), angle, "target"}};
}

}  // namespace c4g_driver
