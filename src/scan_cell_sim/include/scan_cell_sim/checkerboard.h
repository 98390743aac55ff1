// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "scan_cell_sim/shapes.h"

namespace scan_cell_sim {

/// A flat calibration board: a white plate with a checkerboard. Its frame is the one that
/// calibration finds: origin at the first inner corner, x along a row of `columns` corners, y along
/// a column of `rows`, z into the plate. The square before the origin, at x < 0 and y < 0, is
/// black.
struct Checkerboard {
  int columns = 15;           //!< inner corners along x
  int rows = 25;              //!< inner corners along y
  double square_size = 0.02;  //!< [m]
  double margin = 0.04;       //!< [m] of white plate around the squares
  double white = 0.8;         //!< reflectance, 0 .. 1
  double black = 0.06;        //!< reflectance, 0 .. 1
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< in world

  /// Reflectance at a point of the plate [m].
  /// @param blur standard deviations [m] along x and y of what a pixel gathers
  double reflectance(const Eigen::Vector2d& point, const Eigen::Vector2d& blur) const;

  /// The plate, in world.
  Mesh mesh() const;
};

}  // namespace scan_cell_sim
