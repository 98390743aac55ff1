// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/border/border_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace part_recipes::path_design {

using Eigen::Vector3d;
using scan_cell_common::PointTree;

namespace {

Vector3d nearest_on_line(const Vector3d& point, const Vector3d& begin, const Vector3d& end) {
  const Vector3d way = end - begin;
  const double square = way.squaredNorm();
  if (square == 0) return begin;
  return begin + std::clamp((point - begin).dot(way) / square, 0.0, 1.0) * way;
}

}  // namespace

BorderDistance::BorderDistance(const MeshSearch& surface, const std::vector<Trace>& borders)
    : surface_(surface) {
  constexpr double kMost = 100000;  // samples; chosen
  constexpr double kStep = 0.0005;  // [m] chosen: how finely the sides are looked up
  double length = 0;
  for (const Trace& border : borders)
    length += length_of(border);
  step_ = std::max(kStep, length / kMost);
  for (const Trace& border : borders) {
    for (std::size_t i = 0; i < border.points.size(); ++i) {
      const Side side = {border.points[i].position,
                         border.points[(i + 1) % border.points.size()].position};
      const double steps = std::max(1.0, std::ceil((side.end - side.begin).norm() / step_));
      for (double k = 0; k < steps; ++k) {
        samples_.push_back(side.begin + (k + 0.5) / steps * (side.end - side.begin));
        side_of_.push_back(sides_.size());
      }
      sides_.push_back(side);
    }
  }
  if (!samples_.empty()) search_ = std::make_unique<PointTree>(samples_);
}

Vector3d BorderDistance::nearest(const Vector3d& point) const {
  PointTree::Index first = 0;
  double square = 0;
  search_->nearest(point.data(), 1, &first, &square);
  std::vector<std::pair<PointTree::Index, double>> found;
  // A side's sample is at most half a step from any place of it.
  const double reach = std::sqrt(square) + step_;
  search_->within(point.data(), reach * reach, found);
  found.emplace_back(first, square);
  Vector3d best = samples_[first];
  double least = std::numeric_limits<double>::infinity();
  for (const auto& each : found) {
    const Side& side = sides_[side_of_[each.first]];
    const Vector3d place = nearest_on_line(point, side.begin, side.end);
    const double distance = (place - point).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best = place;
  }
  return best;
}

bool BorderDistance::is_beyond(const Vector3d& point, double distance) const {
  if (empty()) return true;
  const Vector3d border = nearest(point);
  if ((border - point).norm() >= distance) return true;
  return length_along(surface_, point, border) >= distance;
}

}  // namespace part_recipes::path_design
