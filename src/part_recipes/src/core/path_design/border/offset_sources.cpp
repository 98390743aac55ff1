// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/border/offset_sources.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace part_recipes::path_design {

using Eigen::Vector3d;

namespace {

class Sources {
 public:
  Sources(const Trace& border, double distance) : distance_(std::abs(distance)) {
    constexpr double kFinest = 0.0001;  // [m] chosen
    constexpr double kShare = 0.1;      // of the distance; chosen
    constexpr double kMost = 20000;     // sources of a border; chosen
    step_ = std::max({kFinest, std::min(0.001, kShare * distance_), length_of(border) / kMost});
    outwards_ = distance < 0;
    drop_repeated(border);
    for (std::size_t i = 0; i < points_.size(); ++i)
      add_side(points_[i], points_[(i + 1) % points_.size()],
               points_[(i + 2) % points_.size()].position);
  }

  OffsetSources take() { return {std::move(sources_), step_}; }

 private:
  /// Keeps each place once: of the two normals at a bend, each side takes its own from the next
  /// points.
  void drop_repeated(const Trace& border) {
    for (const TracePoint& point : border.points)
      if (points_.empty() || point.position != points_.back().position) points_.push_back(point);
    if (points_.size() > 1 && points_.front().position == points_.back().position)
      points_.pop_back();
  }

  OffsetSource source(const TracePoint& at, const Vector3d& along) const {
    const Vector3d direction = in_plane(at.normal.cross(along), at.normal);
    return {at.position, at.normal, outwards_ ? Vector3d(-direction) : direction};
  }

  void add_side(const TracePoint& from, const TracePoint& to, const Vector3d& after) {
    const Vector3d way = to.position - from.position;
    const double steps = std::max(1.0, std::ceil(way.norm() / step_));
    for (double k = 0; k <= steps; ++k)
      sources_.push_back(source(between(from, to, k / steps), way));
    add_turn(to, way, after - to.position);
  }

  void add_turn(const TracePoint& corner, const Vector3d& arriving, const Vector3d& leaving) {
    const OffsetSource first = source(corner, arriving), last = source(corner, leaving);
    const Vector3d axis = first.inwards.cross(last.inwards);
    const bool parts = axis.dot(corner.normal) * (outwards_ ? 1 : -1) > 0;
    const double angle = std::atan2(axis.norm(), first.inwards.dot(last.inwards));
    if (!parts || axis.isZero()) return;
    constexpr double kChord = 1e-6;  // [m] of the arc from the lines between its places; chosen
    const double steps = std::ceil(angle / std::sqrt(8 * kChord / distance_));
    for (double k = 1; k < steps; ++k) {
      OffsetSource turned = first;
      turned.inwards = Eigen::AngleAxisd(k / steps * angle, axis.normalized()) * first.inwards;
      sources_.push_back(turned);
    }
  }

  const double distance_;
  double step_ = 0;
  bool outwards_ = false;
  std::vector<TracePoint> points_;
  std::vector<OffsetSource> sources_;
};

}  // namespace

Vector3d in_plane(const Vector3d& direction, const Vector3d& normal) {
  return (direction - direction.dot(normal) * normal).normalized();
}

OffsetSources offset_sources(const Trace& border, double distance) {
  return Sources(border, distance).take();
}

}  // namespace part_recipes::path_design
