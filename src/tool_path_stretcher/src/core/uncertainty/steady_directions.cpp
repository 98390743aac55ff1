// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/steady_directions.h"

#include <algorithm>
#include <cmath>

#include "geometry/kd_tree.h"
#include "geometry/points.h"

namespace tool_path_stretcher {

std::vector<double> steady_directions(const Surface& object, const Mapping& mapping,
                                      std::vector<GraphConstraint>& constraints) {
  constexpr double kReach = 4;       // spacings; chosen
  constexpr std::size_t kLeast = 6;  // points; chosen
  constexpr double kSameFace = 0.9;  // cosine: up to 26 degrees; chosen
  const Similarity& outer = mapping.similarity;
  std::vector<KdTree::Neighbour> neighbours;
  std::vector<double> deviations;
  for (GraphConstraint& constraint : constraints) {
    object.tree->within(outer * constraint.target, kReach * object.spacing, neighbours);
    if (neighbours.size() < kLeast) {
      deviations.push_back(1);
      continue;
    }
    Points around;
    for (const KdTree::Neighbour& neighbour : neighbours)
      around.push_back(object.points[neighbour.index]);
    const PrincipalFrame frame = principal_frame(around);
    const Eigen::Vector3d normal = outer.rotation.transpose() * frame.axes.col(2);
    const double agreement = normal.dot(constraint.direction);
    if (std::abs(agreement) > kSameFace) {
      constraint.direction = std::copysign(1.0, agreement) * normal;
    }
    deviations.push_back(frame.deviation[2] / frame.deviation[1] /
                         std::sqrt(static_cast<double>(around.size())));
  }
  return deviations;
}

std::vector<double> steady_rims(const Surface& object, const Mapping& mapping,
                                std::vector<GraphConstraint>& constraints) {
  constexpr double kReach = 6;  // spacings; chosen
  const Similarity& outer = mapping.similarity;
  std::vector<KdTree::Neighbour> neighbours;
  std::vector<double> deviations;
  for (GraphConstraint& constraint : constraints) {
    object.edges.tree->within(outer * constraint.target, kReach * object.spacing, neighbours);
    const Eigen::Vector3d outward = outer.rotation * constraint.direction;
    Eigen::Vector3d sum = outward;
    double count = 1;
    for (const KdTree::Neighbour& neighbour : neighbours) {
      const Eigen::Vector3d& other = object.edges.outward[neighbour.index];
      if (other.dot(outward) <= 0) continue;
      sum += other;
      count += 1;
    }
    constraint.direction = outer.rotation.transpose() * sum.normalized();
    deviations.push_back(std::sqrt(2 * std::max(0.0, 1 - sum.norm() / count) / count));
  }
  return deviations;
}

}  // namespace tool_path_stretcher
