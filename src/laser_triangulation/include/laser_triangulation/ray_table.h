// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "scan_cell_common/scanner/scanner_model.h"

namespace laser_triangulation {

/// The undistorted rays of all sensor rows, at any column. Each row is divided into cells of a few
/// columns, each with a cubic through the exact rays at its four Chebyshev nodes. The cells are
/// narrow enough for an error below 1e-9 (0.5 nm at 0.5 m, 0.1 um at 5 m if the ray meets the plane
/// of light at ten degrees). Takes 12 MB for 1696 x 1710 pixels.
class RayTable {
 public:
  static constexpr std::size_t kMaxRows = 128;  //!< per call: fits into the cache; chosen

  /// @throw scan_cell_common::UnusableInput if the lens model cannot be inverted anywhere
  explicit RayTable(const scan_cell_common::CameraIntrinsics& camera);

  /// The rays (x/z, y/z) of one pixel per row, from `first_row` downwards. NaN where the lens model
  /// cannot be inverted accurately.
  /// @param columns -0.5 to width - 0.5
  /// @param count number of rows, all on the sensor, at most kMaxRows
  void find(std::size_t first_row, const float* columns, std::size_t count,
            Eigen::Vector2d* rays) const;

 private:
  /// A cubic in the position 0 .. 1 within the cell; fills one cache line.
  struct alignas(64) Cell {
    Eigen::Vector2d at(double s) const { return c0 + s * (c1 + s * (c2 + s * c3)); }
    Eigen::Vector2d c0, c1, c2, c3;
  };

  static constexpr double kHalfPixel = 0.5;  // [px]

  double choose_width(const scan_cell_common::CameraIntrinsics& camera);
  void fill(const scan_cell_common::CameraIntrinsics& camera, int row, Cell* cells) const;
  double measure(const scan_cell_common::CameraIntrinsics& camera, int row, Cell* cells) const;

  double width_ = 0;       // [px] of a cell
  double per_column_ = 0;  // [1/px]
  std::size_t cells_in_row_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace laser_triangulation
