// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/laser_start.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <random>

#include "geometry/statistics.h"
#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

using Eigen::Vector3d;

std::vector<double> distances(const std::vector<Vector3d>& points, const PlaneFit& plane) {
  std::vector<double> result;
  for (const Vector3d& point : points)
    result.push_back(std::abs(plane.normal.dot(point) - plane.distance));
  return result;
}

PlaneFit least_median(const std::vector<Vector3d>& points) {
  constexpr int kTriples = 300;
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

/// Through the points within `reach` of a plane.
PlaneFit through(const std::vector<Vector3d>& points, const PlaneFit& near, double reach) {
  Vector3d mean = Vector3d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  double count = 0;
  const std::vector<double> off = distances(points, near);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (off[i] <= reach) {
      mean += points[i];
      count += 1;
    }
  mean /= count;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (off[i] <= reach) scatter += (points[i] - mean) * (points[i] - mean).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  const Vector3d spread = axes.eigenvalues().cwiseMax(0).cwiseSqrt();
  PlaneFit plane;
  plane.normal = axes.eigenvectors().col(0);
  plane.distance = plane.normal.dot(mean);
  plane.across = spread[1];
  plane.off_plane = spread[0];
  return plane;
}

}  // namespace

PlaneFit fit_plane(const std::vector<Vector3d>& points) {
  constexpr int kSteps = 3;
  constexpr double kReach = 5 * 1.4826;  // five deviations, in medians of the absolute value
  constexpr double kLeast = 1e-9;        // [m]
  PlaneFit plane = least_median(points);
  for (int step = 0; step < kSteps; ++step)
    plane = through(points, plane, kReach * median(distances(points, plane)) + kLeast);
  return plane;
}

void check_plane(const PlaneFit& plane, const std::string& name) {
  constexpr double kSpread = 0.01;         // [m]
  constexpr double kAboveNoise = 10;       // times what the points are off the plane
  constexpr double kLeastDistance = 1e-3;  // [m]
  if (plane.across < std::max(kSpread, kAboveNoise * plane.off_plane)) {
    throw scan_cell_common::UnusableInput(
        name,
        "its points lie along one line: they spread by " + figure(plane.across * 1e3, " mm") +
            " across it, and are " + figure(plane.off_plane * 1e3, " mm") + " off any plane (RMS)",
        "hold the board at several distances, from the nearest to the farthest that is scanned");
  }
  if (std::abs(plane.distance) < kLeastDistance) {
    throw scan_cell_common::UnusableInput(
        name, "its plane passes the lens by " + figure(plane.distance * 1e3, " mm"),
        "it shows no depth: mount the laser further from the camera");
  }
}

}  // namespace scan_calibration
