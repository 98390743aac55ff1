// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "placement/air.h"

#include <algorithm>
#include <cmath>

#include "geometry/kd_tree.h"
#include "geometry/robust.h"

namespace tool_path_stretcher {
namespace {

/// [m] that a segment is led over the surface; 0 where that is farther than any tool is.
double stand_off_of(std::vector<double> far, double most) {
  const double middle = quantile(std::move(far), 0.5);
  return middle <= most ? middle : 0;
}

}  // namespace

PathDistances distances_of(const ToolPath& path, const Surface& reference, double max_stand_off) {
  constexpr double kSpacings = 5;  // 10 mm on the default grid, as far as holes are bridged; chosen
  constexpr double kShare = 0.05;  // of the size: 4 mm of a plate of 200 x 150 mm; chosen
  const KdTree& tree = reference.whole ? *reference.whole : *reference.tree;
  PathDistances result;
  result.reach = std::max(kSpacings * reference.spacing, kShare * reference.size);
  for (const Segment& segment : path.segments) {
    std::vector<double> far;
    for (const Waypoint& waypoint : segment.waypoints)
      far.push_back(std::sqrt(tree.nearest(waypoint.pose.translation()).squared_distance));
    const double standing = stand_off_of(far, max_stand_off + reference.spacing);
    const double most = standing + std::max(standing, result.reach);
    for (const double each : far)
      result.in_air.push_back(each > most);
    result.far.insert(result.far.end(), far.begin(), far.end());
  }
  return result;
}

ToolPath on_surface(const ToolPath& path, const Surface& reference, double max_stand_off) {
  const PathDistances distances = distances_of(path, reference, max_stand_off);
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
