// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/border.h"

#include "geometry/kd_tree.h"

namespace tool_path_stretcher {

Border::Border(const Surface& surface, const Points& points, double spacing)
    : spacing_(spacing), at_border_(points.size(), false) {
  constexpr double kGaps = 6;  // spacings between the rim points that were found; chosen
  Points rim;
  for (std::size_t i = 0; i < surface.rim.points.size(); ++i) {
    if (!surface.rim.open[i]) continue;
    rim.push_back(surface.rim.points[i]);
    outward_.push_back(surface.rim.outward[i]);
  }
  if (rim.empty()) return;
  rim_.emplace(std::move(rim));
  const double reach = kGaps * surface.spacing + spacing;
  for (std::size_t i = 0; i < points.size(); ++i)
    at_border_[i] = rim_->nearest(points[i]).squared_distance < reach * reach;
}

bool Border::is_outward(const Eigen::Vector3d& point, double distance) const {
  constexpr double kOutward = 0.1;  // cosine: a surface may end on a steep flank; chosen
  const KdTree::Neighbour nearest = rim_->nearest(point);
  const double limit = distance + spacing_;
  if (nearest.squared_distance > limit * limit) return false;
  const Eigen::Vector3d way = point - rim_->points()[nearest.index];
  return outward_[nearest.index].dot(way) > kOutward * way.norm();
}

}  // namespace tool_path_stretcher
