// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/border/offset.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "path_design/border/border.h"
#include "path_design/border/offset_runs.h"

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

class Offset {
 public:
  Offset(const MeshSearch& surface, const std::vector<Trace>& borders, double distance,
         double corner_angle)
      : surface_(surface), distance_(distance), angle_(corner_angle), border_(surface, borders) {
    OffsetRuns made = offset_runs(surface, borders, border_, distance);
    runs_ = std::move(made.all);
    step_ = made.step;
  }

  /// The lines, closed unless their ends lie apart.
  std::vector<Trace> lines() {
    const std::vector<std::size_t> next = successors();
    std::vector<bool> is_next(runs_.size(), false), used(runs_.size(), false);
    for (const std::size_t run : next)
      if (run != kNone) is_next[run] = true;
    std::vector<Trace> result;
    for (const bool open : {true, false}) {
      for (std::size_t i = 0; i < runs_.size(); ++i)
        if (!used[i] && (!open || !is_next[i])) add_line(i, next, used, result);
    }
    return result;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Whether the way from the end of a run to the start of another, or of itself, leads on rather
  /// than back.
  bool is_onwards(const Vector3d& way, std::size_t i, std::size_t j) const {
    constexpr double kSame = 1e-6;  // [m] in one place
    constexpr double kBack = -0.5;  // cosine: beside a ragged border neither is sure; chosen
    const double least = kBack * way.norm();
    return way.norm() < kSame ||
           (way.dot(runs_[i].last_way) > least && way.dot(runs_[j].first_way) > least);
  }

  Vector3d way_to(std::size_t i, std::size_t j) const {
    return runs_[j].points.front().position - runs_[i].points.back().position;
  }

  /// Whether a run continues in the next run of its border: the places between were lost to a
  /// corner or to ragged sides, not to another border.
  bool goes_on_in(std::size_t i, std::size_t j) const {
    constexpr double kNear = 0.95;  // of the distance; chosen
    const Vector3d way = way_to(i, j), middle = runs_[i].points.back().position + way / 2;
    return way.norm() <= farthest() &&
           (border_.nearest(middle) - middle).norm() >= kNear * straight_distance(i);
  }

  /// [m] from the end of a run to the border, straight
  double straight_distance(std::size_t i) const {
    const Vector3d& end = runs_[i].points.back().position;
    return (border_.nearest(end) - end).norm();
  }

  /// [m] largest distance of ends that meet; chosen
  double farthest() const { return std::abs(distance_) + 4 * step_; }

  /// For each run, the one that continues from its end: the next of its border, or else the nearest
  /// first; kNone: none does.
  std::vector<std::size_t> successors() const {
    std::vector<std::size_t> next(runs_.size(), kNone);
    std::vector<bool> taken(runs_.size(), false);
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (!goes_on_in(i, runs_[i].next)) continue;
      next[i] = runs_[i].next;
      taken[next[i]] = true;
    }
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      for (std::size_t j = 0; next[i] == kNone && j < runs_.size(); ++j) {
        const Vector3d way = way_to(i, j);
        if (!taken[j] && way.norm() <= farthest() && is_onwards(way, i, j))
          pairs.emplace_back(way.norm(), i, j);
      }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [apart, i, j] : pairs) {
      if (next[i] != kNone || taken[j]) continue;
      next[i] = j;
      taken[j] = true;
    }
    return next;
  }

  void add_line(std::size_t first, const std::vector<std::size_t>& next, std::vector<bool>& used,
                std::vector<Trace>& lines) const {
    Trace line;
    std::size_t now = first;
    while (now != kNone && !used[now]) {
      used[now] = true;
      line.points.insert(line.points.end(), runs_[now].points.begin(), runs_[now].points.end());
      if (next[now] != kNone) add_meeting(runs_[now], runs_[next[now]], line);
      now = next[now];
    }
    line.closed = now == first;
    finish(line, lines);
  }

  /// Adds the corner in which two runs meet, if it lies within a few steps of their ends.
  void add_meeting(const OffsetRun& run, const OffsetRun& next, Trace& line) const {
    constexpr double kFar = 3;                                    // steps; chosen
    if (run.points.size() < 2 || next.points.size() < 2) return;  // without a direction
    const TracePoint &end = run.points.back(), &begin = next.points.front();
    const Vector3d u = (end.position - run.points[run.points.size() - 2].position).normalized();
    const Vector3d v = (next.points[1].position - begin.position).normalized();
    const double cosine = u.dot(v), square = 1 - cosine * cosine;
    if (square < 1e-6) return;  // [1] straight on: nothing to meet
    const Vector3d way = begin.position - end.position;
    const double s = (way.dot(u) - cosine * way.dot(v)) / square;
    const double t = (cosine * way.dot(u) - way.dot(v)) / square;
    if (std::abs(s) > kFar * step_ || std::abs(t) > kFar * step_) return;
    const Vector3d middle = (end.position + s * u + begin.position + t * v) / 2;
    if (distance_ <= 0) {
      line.points.push_back({middle, end.normal, false});
      return;
    }
    const Foot foot = surface_.nearest(middle);
    line.points.push_back({foot.point, foot.normal, false});
  }

  void finish(const Trace& line, std::vector<Trace>& lines) const {
    Trace apart;
    apart.closed = line.closed;
    for (const TracePoint& point : line.points)
      add_apart(point, apart.points);
    if (apart.closed && apart.points.size() > 1 &&
        (apart.points.front().position - apart.points.back().position).norm() < 1e-7)  // [m] same
      apart.points.pop_back();
    constexpr double kShortest = 4;  // steps: what is shorter is left over of a corner; chosen
    if (apart.points.size() < 3 || length_of(apart) < kShortest * step_) return;
    mark_corners(apart, angle_);
    lines.push_back(std::move(apart));
  }

  const MeshSearch& surface_;
  const double distance_;
  const double angle_;
  const BorderDistance border_;
  double step_ = 0;  // [m] of the sources
  std::vector<OffsetRun> runs_;
};

}  // namespace

std::vector<Trace> offset_from(const MeshSearch& surface, const std::vector<Trace>& borders,
                               double distance, double corner_angle) {
  if (distance == 0) return borders;
  return Offset(surface, borders, distance, corner_angle).lines();
}

}  // namespace part_recipes::path_design
