// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_reader/gcode_arcs.h"

#include <algorithm>
#include <cmath>

namespace tool_path_programs {
namespace {

constexpr double kFlat = 1e-3;  // [mm] out of the plane, or between its two ends
// From LinuxCNC for programs in mm: how far the ends may be from one circle.
constexpr double kRadiusDifference = 0.01;  // [mm]

/// Coordinates in the plane; the axes are ordered so that the normal points at the viewer.
Eigen::Vector2d flat(const Eigen::Vector3d& point, Eigen::Index normal) {
  return {point[(normal + 1) % 3], point[(normal + 2) % 3]};
}

Eigen::Vector2d quarter_turn(const Eigen::Vector2d& vector) {
  return {-vector.y(), vector.x()};
}

std::optional<Eigen::Vector2d> centre_of(const GcodeArc& arc, const Eigen::Vector2d& from,
                                         const Eigen::Vector2d& to) {
  if (!arc.radius)
    return arc.centre_from_start
               ? std::optional<Eigen::Vector2d>(from + flat(*arc.centre_from_start, arc.normal))
               : std::nullopt;
  const double half = 0.5 * (to - from).norm();
  if (std::abs(*arc.radius) < half - kRadiusDifference) return std::nullopt;
  const double height = std::sqrt(std::max(0.0, *arc.radius * *arc.radius - half * half));
  const bool left = arc.clockwise == (*arc.radius < 0);
  return 0.5 * (from + to) + (left ? height : -height) * quarter_turn(to - from) / (2 * half);
}

}  // namespace

std::optional<Eigen::Vector3d> middle_of(const GcodeArc& arc) {
  if (std::abs(arc.to[arc.normal] - arc.from[arc.normal]) > kFlat) return std::nullopt;
  const Eigen::Vector2d from = flat(arc.from, arc.normal);
  const Eigen::Vector2d to = flat(arc.to, arc.normal);
  if ((to - from).norm() < kFlat) return std::nullopt;
  const auto centre = centre_of(arc, from, to);
  if (!centre) return std::nullopt;
  const Eigen::Vector2d begin = from - *centre;
  const Eigen::Vector2d end = to - *centre;
  if (begin.norm() < kFlat || std::abs(begin.norm() - end.norm()) > kRadiusDifference)
    return std::nullopt;
  double sweep = std::atan2(begin.x() * end.y() - begin.y() * end.x(), begin.dot(end));
  if (arc.clockwise) sweep = -sweep;
  if (sweep <= 0) sweep += 2 * M_PI;
  const double half = arc.clockwise ? -0.5 * sweep : 0.5 * sweep;
  const Eigen::Vector2d middle =
      *centre + std::cos(half) * begin + std::sin(half) * quarter_turn(begin);
  Eigen::Vector3d point = arc.from;
  point[(arc.normal + 1) % 3] = middle.x();
  point[(arc.normal + 2) % 3] = middle.y();
  return point;
}

}  // namespace tool_path_programs
