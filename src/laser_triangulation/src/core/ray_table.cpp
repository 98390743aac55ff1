// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_triangulation/ray_table.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "scan_cell_common/errors/errors.h"

namespace laser_triangulation {
namespace {

constexpr double kAllowed = 1e-9;  // of x/z and y/z: 0.5 nm at 0.5 m; chosen

/// Positions in a cell, 0 .. 1, at which the cubic is exact, and at which its error is largest.
const Eigen::Array4d kNodes = 0.5 - 0.5 * (Eigen::Array4d(1, 3, 5, 7) * M_PI / 8).cos();
const Eigen::Array<double, 5, 1> kBetween =
    0.5 - 0.5 * (Eigen::Array<double, 5, 1>(0, 1, 2, 3, 4) * M_PI / 4).cos();

Eigen::Matrix4d from_nodes() {
  Eigen::Matrix4d powers;
  for (int power = 0; power < 4; ++power)
    powers.col(power) = kNodes.pow(power);
  return powers.inverse();
}

/// @param ray start value, if finite; the solution on return, NaN if there is none
void solve(const scan_cell_common::CameraIntrinsics& camera, int row, double column,
           Eigen::Vector2d& ray) {
  const Eigen::Vector2d distorted((column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy);
  if (!ray.allFinite()) ray = distorted;
  if (!camera.undistort(distorted, ray)) ray.setConstant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

RayTable::RayTable(const scan_cell_common::CameraIntrinsics& camera) {
  const bool exact = choose_width(camera) < kAllowed;
  cells_.resize(static_cast<std::size_t>(camera.height) * cells_in_row_);
  for (int row = 0; row < camera.height; ++row) {
    Cell* const cells = &cells_[static_cast<std::size_t>(row) * cells_in_row_];
    fill(camera, row, cells);
    if (!exact) measure(camera, row, cells);
  }
  const auto usable = [](const Cell& cell) { return cell.c0.allFinite(); };
  if (std::none_of(cells_.begin(), cells_.end(), usable)) {
    throw scan_cell_common::UnusableInput("scanner model: camera distortion",
                                          "cannot be inverted anywhere on the sensor",
                                          "calibrate the camera again");
  }
}

void RayTable::find(std::size_t first_row, const float* columns, std::size_t count,
                    Eigen::Vector2d* rays) const {
  std::array<std::uint32_t, kMaxRows> cell;
  std::array<double, kMaxRows> within;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = (columns[i] + kHalfPixel) * per_column_;
    const int whole = static_cast<int>(place);
    cell[i] = static_cast<std::uint32_t>(whole);
    within[i] = place - whole;
  }
  const Cell* row = &cells_[first_row * cells_in_row_];
  for (std::size_t i = 0; i < count; ++i, row += cells_in_row_)
    rays[i] = row[cell[i]].at(within[i]);
}

/// @return the error of the cubics
double RayTable::choose_width(const scan_cell_common::CameraIntrinsics& camera) {
  constexpr double kWidest = 16;    // [px] chosen
  constexpr double kNarrowest = 4;  // [px] chosen
  constexpr int kRows = 32;         // [px] between checked rows: distortion changes slowly
  for (width_ = kWidest;; width_ /= 2) {
    per_column_ = 1 / width_;
    cells_in_row_ = static_cast<std::size_t>(camera.width * per_column_) + 1;
    std::vector<Cell> cells(cells_in_row_);
    double worst = 0;
    for (int row = 0; row < camera.height; row += kRows) {
      fill(camera, row, cells.data());
      worst = std::max(worst, measure(camera, row, cells.data()));
    }
    if (worst < kAllowed || width_ <= kNarrowest) return worst;
  }
}

void RayTable::fill(const scan_cell_common::CameraIntrinsics& camera, int row, Cell* cells) const {
  static const Eigen::Matrix4d kFromNodes = from_nodes();
  Eigen::Vector2d ray = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  for (std::size_t cell = 0; cell < cells_in_row_; ++cell) {
    Eigen::Matrix<double, 4, 2> exact;
    for (int node = 0; node < 4; ++node) {
      solve(camera, row, (static_cast<double>(cell) + kNodes[node]) * width_ - kHalfPixel, ray);
      exact.row(node) = ray;
    }
    const Eigen::Matrix<double, 4, 2> cubic = kFromNodes * exact;
    cells[cell] = {cubic.row(0), cubic.row(1), cubic.row(2), cubic.row(3)};
  }
}

/// The largest error between the nodes. A cell with an error above kAllowed becomes NaN, as where
/// the lens model is about to fold over.
double RayTable::measure(const scan_cell_common::CameraIntrinsics& camera, int row,
                         Cell* cells) const {
  double worst = 0;
  Eigen::Vector2d exact = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < cells_in_row_; ++i) {
    Cell& cell = cells[i];
    double error = 0;
    for (const double s : kBetween) {
      solve(camera, row, (static_cast<double>(i) + s) * width_ - kHalfPixel, exact);
      error = std::fmax(error, (cell.at(s) - exact).norm());  // ignores NaN
    }
    if (error > kAllowed) cell.c0.setConstant(std::numeric_limits<double>::quiet_NaN());
    worst = std::max(worst, error);
  }
  return worst;
}

}  // namespace laser_triangulation
