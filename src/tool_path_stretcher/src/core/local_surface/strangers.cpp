// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "local_surface/strangers.h"

#include <algorithm>
#include <cmath>

#include "geometry/clusters.h"
#include "geometry/points.h"

namespace tool_path_stretcher {
namespace {

/// All scanned points that lie farther off the reference.
Points off_reference(const SurfacePair& surfaces, const Mapping& mapping,
                     const std::vector<Residual>& residuals, double max_off) {
  const auto& [reference, object] = surfaces;
  const double scale = mapping.similarity.scale;
  const auto is_off = [&, &reference = reference](const Residual& residual) {
    if (scale * std::hypot(residual.along_normal, residual.beside) <= max_off) return false;
    const double far = max_off / scale;  // also from the part that no scan was expected to show
    return !reference.whole ||
           reference.whole->nearest(residual.pulled_back).squared_distance > far * far;
  };
  Points off;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (is_off(residuals[i])) off.push_back(object.points[i]);
  }
  for (const Eigen::Vector3d& other : object.others) {
    if (is_off(residual_of(reference, mapping, other))) off.push_back(other);
  }
  return off;
}

/// The points with as many neighbours as on a surface; drops loose points.
Points on_surfaces(const Points& points, double spacing) {
  constexpr double kReach = 2;       // spacings; chosen
  constexpr std::size_t kLeast = 5;  // of about 12 on a surface, itself included; chosen
  Points result;
  if (points.empty()) return result;
  const KdTree tree(points);
  std::vector<KdTree::Neighbour> neighbours;
  for (const Eigen::Vector3d& point : points) {
    tree.within(point, kReach * spacing, neighbours);
    if (neighbours.size() >= kLeast) result.push_back(point);
  }
  return result;
}

/// The cosine of the angle to the viewers' mean direction; 0: viewers unknown.
double facing(const Eigen::Vector3d& normal, const Points& viewers) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& viewer : viewers)
    sum += viewer;
  return normal.dot(sum) / std::max<double>(1, static_cast<double>(viewers.size()));
}

}  // namespace

Strangers::Strangers(const SurfacePair& surfaces, const Mapping& mapping,
                     const std::vector<Residual>& residuals, double max_off) {
  constexpr double kGap = 2.5;        // spacings between neighbours of one patch; chosen
  constexpr std::size_t kLeast = 12;  // points: a patch of 3 by 4 spacings; chosen
  const double spacing = surfaces.object.spacing;
  viewers_ = surfaces.object.seen_from;
  under_counts_ = surfaces.reference.oriented || viewers_.empty();
  length_ = mapping.similarity.scale * length_of(surfaces.reference);
  const KdTree off(on_surfaces(off_reference(surfaces, mapping, residuals, max_off), spacing));
  if (off.points().empty()) return;
  Points points;
  for (const std::vector<std::size_t>& patch : clusters(off, kGap * spacing)) {
    if (patch.size() < kLeast) break;  // the largest come first
    const Points chosen = select(off.points(), patch);
    patches_.push_back(
        {static_cast<double>(chosen.size()) * spacing * spacing, principal_frame(chosen).centroid});
    points.insert(points.end(), chosen.begin(), chosen.end());
    patch_of_.resize(points.size(), patches_.size() - 1);
  }
  for (const Eigen::Vector3d& point : points)
    box_.extend(point);
  if (!points.empty()) points_ = std::make_unique<const KdTree>(std::move(points));
}

std::vector<std::size_t> Strangers::column(const Eigen::Vector3d& at, const Eigen::Vector3d& normal,
                                           double radius, bool is_seen) const {
  constexpr double kReach = 4;     // radii; chosen
  constexpr double kAlong = 0.1;   // cosine: 84 degrees; chosen
  constexpr double kFacing = 0.9;  // cosine: 26 degrees; chosen
  constexpr double kCovers = 1.2;  // radii of spheres one radius apart, which fill the column
  constexpr double kOver = 0.5;    // radii: far up, points beside the place are not over it; chosen
  const double towards = facing(normal, viewers_);
  const Eigen::Vector3d out = std::copysign(1.0, towards) * normal;
  std::vector<KdTree::Neighbour> neighbours;
  std::vector<std::size_t> indices;
  const auto add = [&](const Eigen::Vector3d& middle, double reach, double beside) {
    points_->within(middle, reach, neighbours);
    for (const KdTree::Neighbour& neighbour : neighbours) {
      const Eigen::Vector3d way = points_->points()[neighbour.index] - at;
      const bool is_under = std::abs(towards) >= kAlong && way.dot(out) < 0;
      if ((way - way.dot(normal) * normal).norm() < beside && (under_counts_ || !is_under))
        indices.push_back(neighbour.index);
    }
  };
  add(at, kReach * radius, radius);
  const double farthest =
      std::min(length_, (box_.center() - at).norm() + box_.diagonal().norm() / 2);
  if (!is_seen && std::abs(towards) >= kFacing)
    for (double over = kReach * radius; over < farthest; over += radius)
      add(at + over * out, kCovers * radius, kOver * radius);
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

Strangers::Beside Strangers::beside(const Eigen::Vector3d& at, const Eigen::Vector3d& normal,
                                    double radius, bool is_seen) const {
  Beside found;
  if (!points_) return found;
  const std::vector<std::size_t> indices = column(at, normal, radius, is_seen);
  if (indices.empty()) return found;
  std::vector<std::size_t> counts(patches_.size(), 0);
  for (const std::size_t index : indices)
    ++counts[patch_of_[index]];
  found.points = indices.size();
  const auto most = std::max_element(counts.begin(), counts.end());
  found.patch = patches_[static_cast<std::size_t>(most - counts.begin())];
  return found;
}

}  // namespace tool_path_stretcher
