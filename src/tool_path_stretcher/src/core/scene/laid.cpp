// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/laid.h"

#include <algorithm>
#include <cmath>

#include "geometry/clusters.h"
#include "geometry/points.h"

namespace tool_path_stretcher {
namespace {

double spacing_of(const KdTree& tree) {
  std::vector<KdTree::Neighbour> nearest;
  double sum = 0;
  for (const Eigen::Vector3d& point : tree.points()) {
    tree.nearest(point, 2, nearest);
    sum += std::sqrt(nearest.back().squared_distance);
  }
  return sum / static_cast<double>(tree.points().size());
}

Points both(Points one, const Points& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

}  // namespace

Laid::Laid(const Points& reference, double inlier_distance, const Points& more)
    : tree_(reference), reach_(inlier_distance + spacing_of(tree_)) {
  if (!more.empty()) tree_ = KdTree(both(reference, more));
}

double Laid::explains(const Surface& object, const Piece& piece) const {
  const auto on = std::count_if(piece.begin(), piece.end(),
                                [&](std::size_t i) { return explains(object.points[i]); });
  return static_cast<double>(on) / static_cast<double>(piece.size());
}

Piece explained(const Surface& object, const Laid& reference, double least_of_scraps) {
  constexpr double kSmooth = 0.87;   // cosine, 30 degrees; chosen
  constexpr double kEdge = 0.25;     // spacings of neighbours from the plane; chosen
  constexpr double kOfFace = 0.2;    // of its points; below: a stranger; chosen
  constexpr std::size_t kFace = 50;  // points; fewer may be noise or an edge; chosen
  const auto smooth = [&](std::size_t one, std::size_t other) {
    if (object.blur[one] > kEdge * object.spacing) return false;
    return std::abs(object.normals[one].dot(object.normals[other])) > kSmooth;
  };
  Piece points;
  for (const Piece& face : clusters(*object.tree, kGap * object.spacing, smooth)) {
    const double least = face.size() < kFace ? least_of_scraps : kOfFace;
    if (reference.explains(object, face) >= least)
      points.insert(points.end(), face.begin(), face.end());
  }
  std::sort(points.begin(), points.end());
  return points;
}

bool lie_apart(const Points& one, const Points& other) {
  constexpr double kOther = 0.05;  // of the size; beyond: another thing; chosen
  const PrincipalFrame a = principal_frame(one);
  const PrincipalFrame b = principal_frame(other);
  return (a.centroid - b.centroid).norm() > kOther * a.deviation.norm();
}

}  // namespace tool_path_stretcher
