// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/border/offset_runs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "path_design/border/offset_sources.h"

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

struct Moved {
  TracePoint point;
  bool kept;
  Vector3d onwards;  // along the border, unit length
};

class Runs {
 public:
  Runs(const MeshSearch& surface, const BorderDistance& border, double distance)
      : surface_(surface), border_(border), distance_(distance) {}

  /// Adds the runs of places that are kept, in the order of the border.
  void add(const Trace& border) {
    const OffsetSources sources = offset_sources(border, distance_);
    runs_.step = std::max(runs_.step, sources.step);
    const std::vector<Moved> moved = moved_from(sources);
    bool before = false;
    const std::size_t first = runs_.all.size();
    for (const Moved& each : moved) {
      if (each.kept && !before)
        runs_.all.push_back({{}, runs_.all.size() + 1, each.onwards, each.onwards});
      // Ways cross on a bumpy surface: places that would lead back are left out.
      if (each.kept && goes_on(each, runs_.all.back())) {
        add_apart(each.point, runs_.all.back().points);
        runs_.all.back().last_way = each.onwards;
      }
      before = each.kept;
    }
    if (runs_.all.size() > first) runs_.all.back().next = first;
  }

  OffsetRuns take() { return std::move(runs_); }

 private:
  /// Moves a place over the surface by the distance, straight on in steps.
  Moved move(const OffsetSource& source) const {
    const Vector3d onwards = (distance_ < 0 ? -1 : 1) * source.inwards.cross(source.normal);
    if (distance_ <= 0) {
      const Vector3d end = source.position - distance_ * source.inwards;
      return {{end, source.normal, false}, true, onwards};
    }
    constexpr double kSteps = 32;        // chosen: an arc of 1 rad comes out 0.003 % short
    constexpr double kOffSurface = 0.7;  // of a step: beyond a border, not over an edge; chosen
    constexpr double kOutside = 2;       // spacings: a smoothed border leaves a cloud's; chosen
    const double step = distance_ / kSteps;
    TracePoint now = {source.position, source.normal, false};
    Vector3d direction = source.inwards;
    bool outside = surface_.mesh().spacing > 0;
    for (double gone = 0; gone < kSteps; ++gone) {
      const Vector3d next = now.position + step * direction;
      const Foot foot = surface_.nearest(next);
      const Vector3d off = next - foot.point, above = off.dot(foot.normal) * foot.normal;
      const bool is_off = (off - above).norm() > kOffSurface * step;
      outside = outside && is_off && gone * step < kOutside * surface_.mesh().spacing;
      const Vector3d way = (outside ? Vector3d(next - above) : foot.point) - now.position;
      if ((is_off && !outside) || way.isZero()) return {now, false, onwards};
      direction = in_plane(way, foot.normal);
      now = {now.position + step * way.normalized(), foot.normal, false};
    }
    const Foot foot = surface_.nearest(now.position);
    now = {foot.point, foot.normal, false};
    return {now, is_own(now.position, source.position), onwards};
  }

  /// Whether no other place of the border is nearer than its own source.
  bool is_own(const Vector3d& point, const Vector3d& source) const {
    constexpr double kEqual = 1e-6;  // share; of figures in double precision from single-precision
                                     // searches
    constexpr double kBeside = 0.3;  // of the distance: of the border about the source; chosen
    constexpr double kDrift = 0.02;  // share that a bumpy surface turns the way aside; chosen
    const Vector3d nearest = border_.nearest(point);
    const double straight = (nearest - point).norm(), own_straight = (source - point).norm();
    if (straight >= own_straight * (1 - kEqual)) return true;
    const double own = length_along(surface_, point, source);
    const bool is_flat = own < own_straight * (1 + kEqual);
    const bool is_beside = (nearest - source).norm() < kBeside * distance_;
    const double equal = is_beside && !is_flat ? kDrift : kEqual;
    return length_along(surface_, point, nearest) >= own * (1 - equal);
  }

  bool is_own_outside(const Vector3d& point) const {
    constexpr double kEqual = 1e-6;  // share, as above
    return (border_.nearest(point) - point).norm() >= -distance_ * (1 - kEqual);
  }

  /// The moved places, starting at a lost one, so that no run is cut in two.
  std::vector<Moved> moved_from(const OffsetSources& sources) const {
    std::vector<Moved> moved;
    for (const OffsetSource& source : sources.all) {
      moved.push_back(move(source));
      if (distance_ < 0) moved.back().kept = is_own_outside(moved.back().point.position);
    }
    const auto lost =
        std::find_if(moved.begin(), moved.end(), [](const Moved& each) { return !each.kept; });
    std::rotate(moved.begin(), lost == moved.end() ? moved.begin() : lost, moved.end());
    return moved;
  }

  static bool goes_on(const Moved& moved, const OffsetRun& run) {
    return run.points.empty() ||
           (moved.point.position - run.points.back().position).dot(moved.onwards) > 0;
  }

  const MeshSearch& surface_;
  const BorderDistance& border_;
  const double distance_;
  OffsetRuns runs_;
};

}  // namespace

OffsetRuns offset_runs(const MeshSearch& surface, const std::vector<Trace>& borders,
                       const BorderDistance& border_distance, double distance) {
  Runs runs(surface, border_distance, distance);
  for (const Trace& border : borders)
    runs.add(border);
  return runs.take();
}

void add_apart(const TracePoint& point, std::vector<TracePoint>& points) {
  constexpr double kSame = 1e-7;  // [m] two ends of sides in one place
  if (points.empty() || (points.back().position - point.position).norm() > kSame)
    points.push_back(point);
}

}  // namespace part_recipes::path_design
