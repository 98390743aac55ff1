// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "pass_planner/surface.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace pass_planner {

/// A rectangle with a corner and two sides.
struct Rectangle {
  Eigen::Vector3d corner, first, second;
};

/// A plate in the plane z = 0, a wall on it in the plane x = 0.05, 50 mm high, and a roof over
/// x = 0.09 .. 0.11 in the plane z = 0.1.
inline std::vector<Rectangle> wall_and_roof() {
  return {{{-0.4, -0.4, 0}, {0.8, 0, 0}, {0, 0.8, 0}},
          {{0.05, -0.1, 0}, {0, 0.2, 0}, {0, 0, 0.05}},
          {{0.09, -0.1, 0.1}, {0.02, 0, 0}, {0, 0.2, 0}}};
}

inline SurfaceShape mesh_of(const std::vector<Rectangle>& rectangles) {
  SurfaceShape shape;
  for (const Rectangle& each : rectangles) {
    const auto at = static_cast<std::uint32_t>(shape.points.size());
    for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      shape.points.emplace_back(each.corner + a * each.first + b * each.second);
    shape.triangles.push_back({at, at + 1, at + 2});
    shape.triangles.push_back({at, at + 2, at + 3});
  }
  return shape;
}

/// Points on a square grid, as a cloud would have them.
inline SurfaceShape cloud_of(const std::vector<Rectangle>& rectangles) {
  constexpr double kSpacing = 0.002;  // [m]
  std::vector<Eigen::Vector3d> points, normals;
  for (const Rectangle& each : rectangles) {
    for (double a = 0; a <= each.first.norm(); a += kSpacing) {
      for (double b = 0; b <= each.second.norm(); b += kSpacing) {
        points.emplace_back(each.corner + a * each.first.normalized() +
                            b * each.second.normalized());
        normals.push_back(each.first.cross(each.second).normalized());
      }
    }
  }
  return squares_on(points, normals, kSpacing);
}

/// An ideal scanner: the camera at the flange, the lasers 0.25 m to its sides, and their planes
/// crossing its axis 0.5 m in front of it. The tangent of the light's angle is 0.5.
inline scan_cell_common::ScannerModel ideal_scanner() {
  scan_cell_common::ScannerModel model;
  model.camera.width = model.camera.height = 1000;
  model.camera.fx = model.camera.fy = 1000;
  model.camera.cx = model.camera.cy = 499.5;
  for (const double side : {-1.0, 1.0}) {
    scan_cell_common::LaserPlane laser;
    laser.origin = {0.25 * side, 0, 0};
    laser.normal = Eigen::Vector3d(-0.5 * side, 0, -0.25).normalized();
    laser.distance = laser.normal.dot(laser.origin);
    model.lasers.emplace_back(laser);
  }
  return model;
}

/// A camera looking straight down from 0.5 m above z = 0.
inline Eigen::Isometry3d above(double x) {
  return Eigen::Translation3d(x, 0, 0.5) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
}

}  // namespace pass_planner
