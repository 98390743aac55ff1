// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/parts/path_on_part.h"

#include <cmath>
#include <functional>

#include "parts/shapes.h"
#include "scan_cell_sim/scene.h"

namespace scanner_views {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using tool_path_stretcher::Segment;
using tool_path_stretcher::Waypoint;

/// A line over a part: a = 0 .. 1 along the line gives a point in -1 .. 1 of the part's half width
/// and depth.
using Line = std::function<Vector2d(double a)>;

std::vector<Line> lines_of(PathKind kind, Draws& draws) {
  if (kind == PathKind::kRim) {
    const double inset = draws.between(0.86, 0.94);
    return {[=](double a) {
      const double side = std::fmod(4 * a, 1.0) * 2 - 1;
      if (a < 0.25) return Vector2d(inset * side, -inset);
      if (a < 0.5) return Vector2d(inset, inset * side);
      if (a < 0.75) return Vector2d(-inset * side, inset);
      return Vector2d(-inset, -inset * side);
    }};
  }
  if (kind == PathKind::kWave) {
    const double waves = draws.between(5, 9), high = draws.between(0.4, 0.7);
    return {[=](double a) { return Vector2d(-0.85 + 1.7 * a, high * std::sin(waves * a)); }};
  }
  std::vector<Line> lines;
  for (const double y : {-0.7, -0.25, 0.2, 0.65}) {
    const double at = y + draws.between(-0.15, 0.15), slope = draws.between(-0.1, 0.1);
    lines.emplace_back([=](double a) { return Vector2d(-0.9 + 1.8 * a, at + slope * (a - 0.5)); });
  }
  return lines;
}

/// Whether the surface continues from one waypoint to the next.
bool follows(const Waypoint& from, const Waypoint& to) {
  constexpr double kBend = 0.9;   // cosine, 26 degrees; chosen
  constexpr double kSlope = 0.6;  // height over distance; chosen
  const Vector3d way = to.pose.translation() - from.pose.translation();
  return from.pose.linear().col(2).dot(to.pose.linear().col(2)) > kBend &&
         std::abs(way.dot(from.pose.linear().col(2))) < kSlope * way.norm();
}

}  // namespace

ToolPath path_on(const Mesh& part, PathKind kind, Draws& draws) {
  constexpr int kSteps = 300;      // over all lines; chosen
  constexpr double kSteep = 0.35;  // cosine: steeper faces are not worked on from above; chosen
  constexpr double kAhead = 1e-4;  // of a line, to get its direction
  const scan_cell_sim::Scene scene({part}, 1);
  const Eigen::AlignedBox3d box = box_of(part);
  const auto above = [&](const Vector2d& at) -> Vector3d {
    const Vector2d place = box.center().head<2>() + at.cwiseProduct(box.sizes().head<2>()) / 2;
    return {place.x(), place.y(), box.max().z() + 0.1};
  };
  ToolPath path;
  path.name = "drawn";
  path.has_orientation = true;
  path.process_names = {"speed"};
  const std::vector<Line> lines = lines_of(kind, draws);
  const int steps = kSteps / static_cast<int>(lines.size());
  for (const Line& line : lines) {
    Segment whole{"line", {}};
    const auto end_segment = [&] {
      path.segments.push_back(whole);
      whole.waypoints.clear();
    };
    for (int i = 0; i < steps; ++i) {
      const double a = (i + 0.5) / steps;
      const auto hit = scene.first_hit(above(line(a)), -Vector3d::UnitZ());
      if (!hit || hit->normal.z() < kSteep) {
        end_segment();
        continue;
      }
      const Waypoint next = cases::waypoint_at({hit->point, hit->normal},
                                               above(line(a + kAhead)) - above(line(a - kAhead)));
      if (!whole.waypoints.empty() && !follows(whole.waypoints.back(), next)) end_segment();
      whole.waypoints.push_back(next);
    }
    end_segment();
  }
  return parted(path, [](const Waypoint&) { return true; });
}

}  // namespace scanner_views
