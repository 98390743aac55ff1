// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/residuals.h"

#include <cmath>
#include <limits>

#include "robust.h"

namespace tool_path_stretcher {
namespace {

/// [m] a mapped point of the reference to the scanned surface; NaN where that was not scanned.
double distance_to_scan(const Surface& object, const Eigen::Vector3d& point) {
  constexpr double kReach = 2.5;  // spacings between which the scanned surface is still known
  const KdTree::Neighbour nearest = object.tree->nearest(point);
  const double along = object.normals[nearest.index].dot(point - object.points[nearest.index]);
  const double beside = std::sqrt(std::max(0.0, nearest.squared_distance - along * along));
  if (beside > kReach * object.spacing) return std::numeric_limits<double>::quiet_NaN();
  return std::abs(along);
}

}  // namespace

Residual residual_of(const Surface& reference, const Mapping& mapping,
                     const Eigen::Vector3d& object_point) {
  Residual residual;
  residual.pulled_back = mapping.pull_back(object_point);
  const KdTree::Neighbour nearest = reference.tree->nearest(residual.pulled_back);
  residual.reference = nearest.index;
  residual.along_normal =
      reference.normals[nearest.index].dot(residual.pulled_back - reference.points[nearest.index]);
  const double beside = std::sqrt(
      std::max(0.0, nearest.squared_distance - residual.along_normal * residual.along_normal));
  residual.beside = std::max(0.0, beside - reference.spacing);
  return residual;
}

std::vector<Residual> residuals_of(const Surface& reference, const Mapping& mapping,
                                   const Points& object_points) {
  std::vector<Residual> residuals;
  residuals.reserve(object_points.size());
  for (const Eigen::Vector3d& point : object_points)
    residuals.push_back(residual_of(reference, mapping, point));
  return residuals;
}

Explanation explain(const Surface& reference, const Surface& object, const Mapping& mapping,
                    double inlier_distance) {
  Explanation result;
  double squares = 0;
  std::size_t inliers = 0;
  for (const Residual& residual :
       residuals_of(reference, mapping, select(object.points, object.samples.most))) {
    const double distance =
        mapping.similarity.scale * std::hypot(residual.along_normal, residual.beside);
    result.object_distance.push_back(distance);
    if (distance > inlier_distance) continue;
    squares += distance * distance;
    ++inliers;
  }
  std::size_t covered = 0;
  for (const std::size_t i : reference.samples.most) {
    result.reference_distance.push_back(distance_to_scan(object, mapping * reference.points[i]));
    if (result.reference_distance.back() <= inlier_distance) ++covered;
  }
  result.noise = robust_deviation(result.object_distance);
  result.rms = inliers == 0 ? 0 : std::sqrt(squares / static_cast<double>(inliers));
  result.inlier_ratio =
      static_cast<double>(inliers) / static_cast<double>(object.samples.most.size());
  result.overlap =
      static_cast<double>(covered) / static_cast<double>(reference.samples.most.size());
  return result;
}

bool clearly_better(const Explanation& better, const Explanation& other) {
  constexpr double kDeviations = 3;     // of the noise, and a point counts as not explained
  constexpr double kSignificance = 4;   // standard deviations of the count
  constexpr double kLeastShare = 5e-4;  // of the points compared
  const double threshold = kDeviations * better.noise;
  double only_better = 0;
  double only_other = 0;
  double compared = 0;
  const auto count = [&](const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::isnan(a[i]) || std::isnan(b[i])) continue;
      compared += 1;
      if (a[i] <= threshold && b[i] > threshold) only_better += 1;
      if (b[i] <= threshold && a[i] > threshold) only_other += 1;
    }
  };
  count(better.object_distance, other.object_distance);
  count(better.reference_distance, other.reference_distance);
  const double lead = only_better - only_other;
  return lead > kSignificance * std::sqrt(only_better + only_other) &&
         lead > kLeastShare * compared;
}

}  // namespace tool_path_stretcher
