// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "quality/point_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scan_calibration {
namespace {

/// Sorted depths [m] of the points where a laser's line was seen.
std::vector<double> depths_of(const JointEstimate& estimate, const BoardSurface& surface,
                              std::size_t laser) {
  std::vector<double> depths;
  LineOffset offset;
  for (std::size_t i = 0; i < estimate.views.size(); ++i) {
    const BoardSight sight = sight_of(estimate.state, estimate.views[i], i);
    const LinePoints& line = estimate.views[i].lines[laser];
    for (std::size_t k = 0; k < line.pixels.size(); ++k)
      if (line.weights[k] > 0 && line_offset(estimate.state, surface, sight, line.pixels[k],
                                             estimate.state.planes[laser], offset))
        depths.push_back(offset.point.z());
  }
  std::sort(depths.begin(), depths.end());
  return depths;
}

/// Pixels that see a laser's plane at a depth, evenly along the part of that line within the
/// image.
std::vector<Eigen::Vector2d> pixels_at(const ScannerState& state, std::size_t laser, double depth) {
  constexpr int kSteps = 400;         // to each side, chosen: fine enough to find the image's edge
  constexpr std::size_t kWanted = 5;  // chosen
  constexpr double kMaxMiss = 1e-6;   // of the reach, chosen: rounding
  const scan_cell_common::CameraIntrinsics camera = state.intrinsics();
  const Eigen::Vector3d& plane = state.planes[laser];
  const double left = 1 - plane.z() * depth;  // plane.x x + plane.y y = left
  const Eigen::Vector2d across = plane.head<2>();
  const Eigen::Vector2d foot = left / across.squaredNorm() * across;
  const Eigen::Vector2d along = Eigen::Vector2d(-across.y(), across.x()).normalized();
  const double reach = depth * std::hypot(camera.width, camera.height) / camera.fx;
  std::vector<Eigen::Vector2d> seen;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const Eigen::Vector2d place = foot + i * reach / kSteps * along;
    const Eigen::Vector2d pixel = camera.project({place.x(), place.y(), depth});
    if (!camera.contains(pixel)) continue;
    // Beyond its fold the lens model maps other places to the same pixels
    const std::optional<Eigen::Vector3d> ray = ray_of(camera, pixel);
    if (ray && (ray->head<2>() * depth - place).norm() < kMaxMiss * reach) seen.push_back(pixel);
  }
  std::vector<Eigen::Vector2d> result;
  for (std::size_t i = 0; i < kWanted && !seen.empty(); ++i)
    result.push_back(seen[i * (seen.size() - 1) / (kWanted - 1)]);
  return result;
}

}  // namespace

std::vector<ScanPlace> scan_places(const JointEstimate& estimate, const BoardSurface& surface) {
  std::vector<ScanPlace> places;
  for (std::size_t laser = 0; laser < estimate.state.planes.size(); ++laser) {
    const std::vector<double> depths = depths_of(estimate, surface, laser);
    for (const std::size_t percent : {5, 50, 95}) {
      if (depths.empty()) continue;
      const double depth = depths[percent * (depths.size() - 1) / 100];
      for (const Eigen::Vector2d& pixel : pixels_at(estimate.state, laser, depth))
        places.push_back({laser, depth, pixel});
    }
  }
  return places;
}

Eigen::MatrixXd triangulation_derivative(const JointEstimate& estimate, const Knowledge& knowledge,
                                         const ScanPlace& place) {
  return derivative(estimate.state, knowledge, [&](const ScannerState& at) -> Eigen::VectorXd {
    const std::optional<Eigen::Vector3d> ray = ray_of(at.intrinsics(), place.pixel);
    if (!ray) return Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    return at.flange_to_camera * (*ray / at.planes[place.laser].dot(*ray));
  });
}

std::vector<PointUncertainty> point_uncertainties(const JointEstimate& estimate,
                                                  const Knowledge& knowledge,
                                                  const std::vector<ScanPlace>& places,
                                                  const std::vector<std::string>& lasers) {
  std::vector<PointUncertainty> result;
  for (const ScanPlace& place : places) {
    const Eigen::MatrixXd rows = triangulation_derivative(estimate, knowledge, place);
    result.push_back(
        {lasers[place.laser], place.depth, place.pixel, 1e3 * knowledge.deviation(rows)});
  }
  return result;
}

}  // namespace scan_calibration
