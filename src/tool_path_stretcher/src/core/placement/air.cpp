// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "placement/air.h"

#include <algorithm>
#include <cmath>

#include "geometry/kd_tree.h"
#include "geometry/robust.h"

namespace tool_path_stretcher {
namespace {

/// [m] distance at which a segment is led over the surface; 0 if it touches, or if that is farther
/// than any tool's stand-off.
/// @param touching [m] greatest distance of a touching waypoint
double stand_off_of(std::vector<double> far, double touching, double most) {
  constexpr double kMaxTouching = 0.1;  // of the waypoints; chosen
  const auto touches = [=](double each) { return each <= touching; };
  const auto count = static_cast<double>(std::count_if(far.begin(), far.end(), touches));
  if (count > kMaxTouching * static_cast<double>(far.size())) return 0;
  const double middle = quantile(std::move(far), 0.5);
  return middle <= most ? middle : 0;
}

}  // namespace

PathDistances distances_of(const ToolPath& path, const Surface& reference,
                           const StretchParameters& parameters) {
  constexpr double kSpacings = 2;  // a sparse surface is not a hole; chosen
  const KdTree& tree = reference.whole ? *reference.whole : *reference.tree;
  PathDistances result;
  result.reach = std::max(parameters.max_hole_distance, kSpacings * reference.spacing);
  const double most_standing = parameters.max_stand_off + reference.spacing;
  for (const Segment& segment : path.segments) {
    std::vector<double> far;
    for (const Waypoint& waypoint : segment.waypoints)
      far.push_back(std::sqrt(tree.nearest(waypoint.pose.translation()).squared_distance));
    const double standing = stand_off_of(far, reference.spacing, most_standing);
    const double most = standing + std::max(standing, result.reach);
    for (const double each : far)
      result.in_air.push_back(each > most);
    result.far.insert(result.far.end(), far.begin(), far.end());
  }
  return result;
}

ToolPath on_surface(const ToolPath& path, const Surface& reference,
                    const StretchParameters& parameters) {
  const PathDistances distances = distances_of(path, reference, parameters);
  ToolPath result = path;
  auto in_air = distances.in_air.begin();
  for (Segment& segment : result.segments) {
    std::vector<Waypoint> kept;
    for (const Waypoint& waypoint : segment.waypoints) {
      if (!*in_air++) kept.push_back(waypoint);
    }
    segment.waypoints = std::move(kept);
  }
  return result;
}

}  // namespace tool_path_stretcher
