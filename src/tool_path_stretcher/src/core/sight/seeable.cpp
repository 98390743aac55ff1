// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "sight/seeable.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "geometry/kd_tree.h"
#include "surface/complete_surface.h"

namespace tool_path_stretcher {
namespace {

constexpr double kGrazing = 0.17;  // cosine: 80 degrees; a line on a steeper face is not found
// Sine of 20 degrees: a viewer is not at infinity, and also sees walls parallel to the mean
// direction.
constexpr double kBeside = 0.34;

/// Height of a surface towards a viewer at infinity, per cell of a plane perpendicular to the
/// direction.
class DepthImage {
 public:
  DepthImage(const Surface& surface, const Eigen::Vector3d& direction)
      : direction_(direction),
        along_(direction.unitOrthogonal()),
        across_(direction.cross(along_)),
        cell_(surface.spacing) {
    for (const Eigen::Vector3d& point : surface.points) {
      const double height = direction_.dot(point);
      const auto [entry, is_new] = highest_.emplace(key_of(point, 0, 0), height);
      if (!is_new) entry->second = std::max(entry->second, height);
    }
  }

  /// Whether something is in front of a point. A face up to 80 degrees from the direction does not
  /// hide itself.
  bool hides(const Eigen::Vector3d& point) const {
    constexpr double kSteps = 2;  // cells to the far side of a neighbouring one
    const double most = direction_.dot(point) + kSteps * cell_ / kGrazing;
    for (const int i : {-1, 0, 1}) {
      for (const int k : {-1, 0, 1}) {
        const auto found = highest_.find(key_of(point, i, k));
        if (found != highest_.end() && found->second > most) return true;
      }
    }
    return false;
  }

 private:
  std::uint64_t key_of(const Eigen::Vector3d& point, int i, int k) const {
    const auto column = static_cast<std::int64_t>(std::floor(along_.dot(point) / cell_)) + i;
    const auto row = static_cast<std::int64_t>(std::floor(across_.dot(point) / cell_)) + k;
    return (static_cast<std::uint64_t>(column) << 32U) ^
           (static_cast<std::uint64_t>(row) & 0xFFFFFFFFU);
  }

  Eigen::Vector3d direction_, along_, across_;
  double cell_;  // [m]
  std::unordered_map<std::uint64_t, double> highest_;
};

/// Tells real edges of the surface from places where only the visible part ends.
void mark_horizon(const Surface& surface, Rim& rim) {
  constexpr double kReach = 2;   // spacings: distance of samples from their edge; chosen
  constexpr double kBent = 0.8;  // cosine: an edge bends by more than 37 degrees; chosen
  std::vector<KdTree::Neighbour> neighbours;
  const auto ends_at = [&](const Eigen::Vector3d& point) {
    if (!surface.rim.tree) return false;
    surface.rim.tree->within(point, kReach * surface.spacing, neighbours);
    return std::any_of(neighbours.begin(), neighbours.end(),
                       [&](const auto& each) { return surface.rim.open[each.index]; });
  };
  for (std::size_t i = 0; i < rim.points.size(); ++i) {
    if (ends_at(rim.points[i])) continue;
    const Eigen::Vector3d& normal = surface.normals[surface.tree->nearest(rim.points[i]).index];
    surface.tree->within(rim.points[i], kReach * surface.spacing, neighbours);
    rim.horizon[i] = std::all_of(neighbours.begin(), neighbours.end(), [&](const auto& each) {
      return surface.normals[each.index].dot(normal) > kBent;
    });
  }
}

}  // namespace

Surface seeable_part(const Surface& surface, const Points& directions) {
  constexpr double kOff = 2.5;  // spacings: beyond the cells beside a point's own
  std::vector<bool> seen(surface.points.size(), false);
  for (const Eigen::Vector3d& direction : directions) {
    const DepthImage image(surface, direction);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double facing = surface.normals[i].dot(direction);
      const double side = !surface.closed && facing < 0 ? -1 : 1;
      if (seen[i] || side * facing < kGrazing - kBeside) continue;
      // Tests from off the surface, so that a wall is not hidden by its own upper edge.
      seen[i] =
          !image.hides(surface.points[i] + side * kOff * surface.spacing * surface.normals[i]);
    }
  }
  Surface part;
  part.oriented = surface.oriented;
  part.whole = surface.tree;
  part.whole_normals = surface.normals;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i]) continue;
    part.points.push_back(surface.points[i]);
    part.normals.push_back(surface.normals[i]);
  }
  if (part.points.empty()) return part;
  complete(part);
  mark_horizon(surface, part.rim);
  std::copy(part.rim.horizon.begin(), part.rim.horizon.end(), part.edges.horizon.begin());
  return part;
}

}  // namespace tool_path_stretcher
