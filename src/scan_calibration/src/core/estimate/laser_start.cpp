// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/laser_start.h"

#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <random>

#include "geometry/statistics.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

using Eigen::Vector3d;

std::vector<double> distances(const std::vector<Vector3d>& points, const PlaneFit& plane) {
  std::vector<double> result;
  for (const Vector3d& point : points)
    result.push_back(std::abs(plane.normal.dot(point) - plane.distance));
  return result;
}

PlaneFit min_median(const std::vector<Vector3d>& points) {
  constexpr int kTriples = 300;  // chosen: with half outliers all miss once in 10^17
  std::mt19937 generator(1);
  const auto draw = [&] { return points[generator() % points.size()]; };
  PlaneFit best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTriples; ++i) {
    const Vector3d a = draw(), b = draw(), c = draw();
    const Vector3d normal = (b - a).cross(c - a);
    if (!(normal.norm() > 0)) continue;
    PlaneFit plane;
    plane.normal = normal.normalized();
    plane.distance = plane.normal.dot(a);
    const double middle = median(distances(points, plane));
    if (middle < least) {
      least = middle;
      best = plane;
    }
  }
  return best;
}

}  // namespace

PlaneFit plane_through(const std::vector<Vector3d>& points) {
  const auto count = static_cast<double>(points.size());
  Vector3d mean = Vector3d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vector3d& point : points)
    mean += point;
  mean /= count;
  for (const Vector3d& point : points)
    scatter += (point - mean) * (point - mean).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  const Vector3d spread = axes.eigenvalues().cwiseMax(0).cwiseSqrt();
  PlaneFit plane;
  plane.normal = axes.eigenvectors().col(0);
  plane.distance = plane.normal.dot(mean);
  plane.across = spread[1];
  plane.off_plane = spread[0];
  return plane;
}

PlaneFit fit_plane(const std::vector<Vector3d>& points) {
  constexpr int kSteps = 3;           // chosen: the set of near points then stays the same
  constexpr double kDeviations = 5;   // chosen: noise stays within
  constexpr double kMinReach = 1e-9;  // [m] rounding, where the points are exact
  PlaneFit plane = min_median(points);
  for (int step = 0; step < kSteps; ++step) {
    const std::vector<double> off = distances(points, plane);
    const double reach = kDeviations * kDeviationPerMedian * median(off) + kMinReach;
    std::vector<Vector3d> near;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (off[i] <= reach) near.push_back(points[i]);
    plane = plane_through(near);
  }
  return plane;
}

std::vector<Vector3d> laser_points(const ScannerState& state, const BoardSurface& surface,
                                   const BoardViews& views,
                                   const std::vector<Eigen::Isometry3d>& boards, std::size_t laser,
                                   const std::string& name) {
  std::vector<Vector3d> points;
  LineOffset offset;
  for (std::size_t i = 0; i < views.size(); ++i)
    for (const Eigen::Vector2d& pixel : views[i].lines[laser].pixels)
      if (line_offset(state, surface, board_sight(boards[i]), pixel, Vector3d::UnitX(), offset))
        points.push_back(offset.point);
  if (points.size() < 3) {
    throw scan_cell_common::UnusableInput(
        name, fmt::format("{} points of its line lie on the board", points.size()),
        "check that its peaks belong to these views, and that it shows in three or more");
  }
  return points;
}

void check_plane(const PlaneFit& plane, const std::string& name) {
  constexpr double kMinSpread = 0.01;     // [m] chosen
  constexpr double kMinSpreadRatio = 10;  // spread over distance from the plane, chosen
  constexpr double kMinDistance = 1e-3;   // [m] chosen: less shows no depth
  if (plane.across < std::max(kMinSpread, kMinSpreadRatio * plane.off_plane)) {
    throw scan_cell_common::UnusableInput(
        name,
        fmt::format("its points lie along one line: they spread by {} across it and miss the best "
                    "plane by {} (RMS)",
                    millimetres(plane.across), millimetres(plane.off_plane)),
        "hold the board at several distances, over the whole range that will be scanned");
  }
  if (std::abs(plane.distance) < kMinDistance) {
    throw scan_cell_common::UnusableInput(
        name,
        fmt::format("its plane passes within {} of the lens",
                    millimetres(std::abs(plane.distance))),
        "it shows no depth: mount the laser further from the camera");
  }
}

}  // namespace scan_calibration
