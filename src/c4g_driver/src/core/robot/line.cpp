// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/line.h"

#include <cmath>

#include "scan_cell_common/timed_pose.h"

namespace c4g_driver {
namespace {

/// From one angle to the other, the shorter way round [rad].
double shorter_way(double from, double to) {
  return std::remainder(to - from, 2 * M_PI);
}

}  // namespace

Line::Line(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, bool euler)
    : from_(from), to_(to), euler_(euler), angles_(to_euler(from.linear())) {
  const EulerAngles end = to_euler(to.linear());
  change_ << shorter_way(angles_.a, end.a), shorter_way(angles_.e, end.e),
      shorter_way(angles_.r, end.r);
}

Eigen::Isometry3d Line::at(double way) const {
  Eigen::Isometry3d pose = scan_cell_common::interpolate(from_, to_, way);
  if (euler_) {
    const Eigen::Vector3d turned = way * change_;
    pose.linear() =
        from_euler({angles_.a + turned[0], angles_.e + turned[1], angles_.r + turned[2]});
  }
  return pose;
}

double Line::length() const {
  return (to_.translation() - from_.translation()).norm();
}

double Line::angle() const {
  if (euler_) return change_.cwiseAbs().maxCoeff();
  return Eigen::AngleAxisd(from_.linear().transpose() * to_.linear()).angle();
}

}  // namespace c4g_driver
