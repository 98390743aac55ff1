// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/kinematics.h"

#include <cmath>

namespace c4g_driver {

Eigen::Isometry3d flange_at(const Joints& joints) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  using Shift = Eigen::Translation3d;
  constexpr double kQuarter = M_PI / 2;
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();
  flange = flange * AngleAxisd(-joints[0], Vector3d::UnitZ());
  flange = flange * Shift(0.150, 0, 0.450) * AngleAxisd(joints[1], Vector3d::UnitY());
  flange = flange * Shift(0, 0, 0.590) * AngleAxisd(-kQuarter - joints[2], Vector3d::UnitY());
  flange = flange * Shift(0.64707, 0, 0.130) * AngleAxisd(-joints[3], Vector3d::UnitX());
  flange = flange * AngleAxisd(joints[4], Vector3d::UnitY());
  flange = flange * Shift(0.095, 0, 0) * AngleAxisd(-joints[5], Vector3d::UnitX());
  flange.linear() *= (Eigen::Matrix3d() << 0, 0, 1, 0, -1, 0, 1, 0, 0).finished();  // z points out
  return flange;
}

}  // namespace c4g_driver
