// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "placement/stand_off.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/kd_tree.h"
#include "geometry/robust.h"

namespace tool_path_stretcher {
namespace {

/// [m] height of a point over the surface beside it, along the normal; 0 if it touches, that is if
/// it is less than the spacing can show. The two are blended in between.
double stand_off(const Surface& reference, const Eigen::Vector3d& at,
                 const Eigen::Vector3d& normal) {
  constexpr std::size_t kNeighbours = 7;  // chosen
  constexpr double kTouching = 0.3;       // spacings; chosen
  std::vector<KdTree::Neighbour> neighbours;
  reference.tree->nearest(at, kNeighbours, neighbours);
  std::vector<double> heights;
  for (const KdTree::Neighbour& neighbour : neighbours) {
    const Eigen::Vector3d& other = reference.normals[neighbour.index];
    const double height = other.dot(at - reference.points[neighbour.index]);
    heights.push_back(std::copysign(1.0, other.dot(normal)) * height);
  }
  const double height = quantile(std::move(heights), 0.5);
  const double touching = kTouching * reference.spacing;
  const double apart = std::clamp(std::abs(height) / touching - 1, 0.0, 1.0);
  return apart * height;
}

/// Whether a segment is led over the surface at a constant distance. A few waypoints past an edge,
/// or a move through the air, are not a stand-off.
bool is_even(const std::vector<double>& heights) {
  constexpr double kMaxTouching = 0.1;  // of the waypoints; chosen
  constexpr double kUneven = 0.2;       // of the stand-off; chosen
  const auto touching = static_cast<double>(std::count(heights.begin(), heights.end(), 0.0));
  if (touching > kMaxTouching * static_cast<double>(heights.size())) return false;
  const double middle = quantile(heights, 0.5);
  std::vector<double> off;
  for (const double height : heights)
    off.push_back(height - middle);
  return robust_deviation(std::move(off)) <= kUneven * std::abs(middle);
}

}  // namespace

std::vector<double> stand_offs(const Segment& segment, const Track& track,
                               const Surface& reference) {
  std::vector<double> result;
  for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
    const Eigen::Vector3d at = segment.waypoints[i].pose.translation();
    result.push_back(stand_off(reference, at, track.stations[i].surface.normal));
  }
  const bool even = is_even(result);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!even || track.stations[i].in_air) result[i] = 0;
  }
  return result;
}

}  // namespace tool_path_stretcher
