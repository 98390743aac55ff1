// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

#include "laser_triangulation/scanner_model.h"

namespace laser_triangulation {

/// The undistorted rays of all sensor rows, for whole rows and any column: exact rays at nodes in
/// each row, and the cubic through the four nodes around a column (Lagrange) between them. The
/// nodes are set so close that the cubic is off by less than 1e-8 (5 nm at 0.5 m).
class RayTable {
 public:
  explicit RayTable(const CameraIntrinsics& camera);

  /// The ray (x/z, y/z) of a pixel on the sensor; NaN where the lens model cannot be undone.
  Eigen::Vector2d ray(std::size_t row, double column) const {
    const double place = (column - kFirstColumn) * per_spacing_;
    const auto below = static_cast<std::ptrdiff_t>(place);
    const std::ptrdiff_t first = std::clamp<std::ptrdiff_t>(below - 1, 0, nodes_ - 4);
    const double a = place - static_cast<double>(first);  // 0 .. 3, mostly 1 .. 2
    const double b = a - 1, c = a - 2, d = a - 3;
    const Eigen::Vector2d* node =
        &rays_[row * static_cast<std::size_t>(nodes_) + static_cast<std::size_t>(first)];
    return (-b * c * d / 6) * node[0] + (a * c * d / 2) * node[1] + (-a * b * d / 2) * node[2] +
           (a * b * c / 6) * node[3];
  }

 private:
  static constexpr double kFirstColumn = -1;  // half a pixel left of the sensor's edge

  void fill(const CameraIntrinsics& camera, double spacing);
  double error(const CameraIntrinsics& camera) const;

  double per_spacing_ = 0;    // [1/px]
  std::ptrdiff_t nodes_ = 0;  // in a row
  std::vector<Eigen::Vector2d> rays_;
};

}  // namespace laser_triangulation
