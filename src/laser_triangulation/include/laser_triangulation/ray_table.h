// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "scan_cell_common/scanner/scanner_model.h"

namespace laser_triangulation {

/// The undistorted rays of all sensor rows, for whole rows and any column: in each row a cubic for
/// every few columns, through the exact rays at the four Chebyshev nodes of that cell. The cells
/// are so narrow that the cubics are off by less than 1e-9 (0.5 nm at 0.5 m, 0.1 um at 5 m where
/// the plane of light is met at ten degrees). 12 MB for 1696 x 1710 pixels.
class RayTable {
 public:
  static constexpr std::size_t kMaxRows = 128;  //!< in one call: fits into the cache; chosen

  /// @throw scan_cell_common::UnusableInput if the lens model cannot be inverted anywhere
  explicit RayTable(const scan_cell_common::CameraIntrinsics& camera);

  /// The rays (x/z, y/z) of one pixel a row, from `first_row` downwards. NaN where the lens model
  /// cannot be inverted, or only inaccurately.
  /// @param columns -0.5 to width - 0.5
  /// @param count rows, all of them on the sensor, at most kMaxRows
  void find(std::size_t first_row, const float* columns, std::size_t count,
            Eigen::Vector2d* rays) const;

 private:
  /// A cubic in the position within the cell, 0 .. 1; fills one cache line.
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
