// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "placement/expected_error.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace tool_path_stretcher {
namespace {

/// [m^2] of the height to which a waypoint was set, from the measurement and the variance of the
/// mapping before it.
double height_variance(const PlacedHeight& height, double mapping_variance) {
  const double before = mapping_variance + height.signal_variance;
  if (!height.measured) {
    return before + height.variance + std::pow(height.hole, 2) * height.slope_variance;
  }
  const double followed = before / (before + height.variance);
  return followed * height.variance + std::pow(followed * height.seen - height.applied, 2);
}

void expect_along(const MappingError::Covariance& covariance, double common,
                  const PlacedHeight& height, WaypointQuality& quality) {
  Eigen::Matrix<double, 3, 2> surface;
  surface.col(0) = height.normal.unitOrthogonal();
  surface.col(1) = height.normal.cross(surface.col(0));
  Eigen::Matrix2d flat = surface.transpose() * covariance.all * surface;
  flat.diagonal().array() += common * common;
  // A dented or filed surface moved along either the old normal or the new one.
  const Eigen::Vector2d aside = height.applied * (surface.transpose() * height.slope);
  flat += aside * aside.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(flat);
  const Eigen::Vector2d most = solver.eigenvectors().col(1);
  const Eigen::Matrix2d assumed = surface.transpose() * covariance.assumed * surface;
  quality.least_known = surface * most;
  quality.expected_error_tangential = std::sqrt(std::max(0.0, flat.trace()));
  quality.expected_error_across = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  quality.position_measured = most.dot(assumed * most) < most.dot(flat * most) / 2;
}

/// [rad] of the tool's axes: the mapping's error about the normal, and the remaining error of the
/// tilt after the scanned surface was used.
double turn_error(const PlacedHeight& height) {
  const double about_normal = height.normal.dot(height.turn_covariance * height.normal);
  return std::sqrt(std::max(0.0, about_normal + 2 * height.tilt_variance));
}

}  // namespace

void expect_errors(const ToolPath& path, const MappingError& mapping_error, Placement& placement) {
  std::size_t index = 0;
  for (const Segment& segment : path.segments) {
    for (const Waypoint& waypoint : segment.waypoints) {
      const PlacedHeight& height = placement.heights[index];
      const Eigen::Vector3d at = waypoint.pose.translation();
      WaypointQuality& quality = placement.quality[index];
      MappingError::Covariance covariance = height.covariance;
      if (quality.in_air) {
        covariance.all.diagonal().array() +=
            mapping_error.lever_variance(at, height.base, height.slope_variance);
      }
      quality.expected_error_normal =
          std::sqrt(height_variance(height, height.normal.dot(covariance.all * height.normal)));
      expect_along(covariance, mapping_error.common(), height, quality);
      quality.position_measured = quality.position_measured && !quality.in_air;
      if (path.has_orientation) quality.expected_error_orientation = turn_error(height);
      ++index;
    }
  }
}

}  // namespace tool_path_stretcher
