// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>

/// Flange of a Comau Smart5 SiX after Denavit and Hartenberg (1955), from the data sheet's lengths:
/// rotation and shift along z, then along the new x. Independent of the URDF, KDL and the emulator.
inline Eigen::Isometry3d flange_by_denavit_hartenberg(const Eigen::Matrix<double, 6, 1>& q) {
  struct Row {
    double theta, d, a, alpha;
  };
  const double quarter = M_PI / 2;
  const std::array<Row, 6> table = {{{-q[0], 0.450, 0.150, -quarter},
                                     {q[1] - quarter, 0, 0.590, M_PI},
                                     {q[2] + quarter, 0, 0.130, quarter},
                                     {-q[3], 0.64707, 0, quarter},
                                     {q[4], 0, 0, -quarter},
                                     {-q[5], 0.095, 0, 0}}};
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (const Row& row : table) {
    pose = pose * Eigen::AngleAxisd(row.theta, Eigen::Vector3d::UnitZ()) *
           Eigen::Translation3d(row.a, 0, row.d) *
           Eigen::AngleAxisd(row.alpha, Eigen::Vector3d::UnitX());
  }
  return pose;
}
