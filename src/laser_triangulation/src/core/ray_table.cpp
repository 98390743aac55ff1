// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_triangulation/ray_table.h"

#include <cmath>
#include <limits>

namespace laser_triangulation {
namespace {

Eigen::Vector2d exact_ray(const CameraIntrinsics& camera, double row, double column) {
  const Eigen::Vector2d distorted((column - camera.cx) / camera.fx, (row - camera.cy) / camera.fy);
  Eigen::Vector2d ray = distorted;
  if (camera.undistort(distorted, ray)) return ray;
  return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

RayTable::RayTable(const CameraIntrinsics& camera) {
  constexpr double kAllowed = 1e-8;
  constexpr double kWidest = 16;  // [px]
  constexpr double kClosest = 1;
  double spacing = kWidest;
  fill(camera, spacing);
  while (error(camera) > kAllowed && spacing > kClosest) {
    spacing /= 2;
    fill(camera, spacing);
  }
}

void RayTable::fill(const CameraIntrinsics& camera, double spacing) {
  per_spacing_ = 1 / spacing;
  nodes_ = std::max<std::ptrdiff_t>(
      4, static_cast<std::ptrdiff_t>(std::ceil((camera.width - kFirstColumn) / spacing)) + 1);
  rays_.clear();
  rays_.reserve(static_cast<std::size_t>(camera.height * nodes_));
  for (int row = 0; row < camera.height; ++row) {
    for (std::ptrdiff_t node = 0; node < nodes_; ++node) {
      rays_.push_back(exact_ray(camera, row, kFirstColumn + static_cast<double>(node) * spacing));
    }
  }
}

double RayTable::error(const CameraIntrinsics& camera) const {
  constexpr int kRows = 64;  // between two that are looked at; distortion changes slowly
  double worst = 0;
  for (int row = 0; row < camera.height; row += kRows) {
    for (std::ptrdiff_t node = 0; node + 1 < nodes_; ++node) {
      const double column = kFirstColumn + (static_cast<double>(node) + 0.5) / per_spacing_;
      const double off =
          (ray(static_cast<std::size_t>(row), column) - exact_ray(camera, row, column)).norm();
      worst = std::fmax(worst, off);  // passes over NaN
    }
  }
  return worst;
}

}  // namespace laser_triangulation
