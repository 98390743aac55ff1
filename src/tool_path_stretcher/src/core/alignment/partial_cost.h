// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/points.h"

namespace tool_path_stretcher {

/// Least share of either surface that must be known on the other, so that a few points do not
/// decide; chosen.
constexpr double kLeastKnown = 0.35;

/// [m] distance from a surface that is known to within its spacing
/// @param way vector from its nearest point [m]
inline double off_surface(const Eigen::Vector3d& way, const Eigen::Vector3d& normal,
                          double spacing) {
  const double along = normal.dot(way);
  const double beside = std::sqrt(std::max(0.0, way.squaredNorm() - along * along));
  return std::hypot(along, std::max(0.0, beside - spacing));
}

/// RMS distance, each point counted up to a cap. An unknown point counts a middling distance: it
/// speaks against a pose, but less than one that lies off the surface.
class PartialCost {
 public:
  /// @param size of the object [m]
  explicit PartialCost(double size) : cap_(kCap * size) {}

  void add(double distance) {
    sum_ += std::pow(std::min(distance, cap_), 2);
    ++known_;
  }

  /// @param all number of points, known or not
  double of(double all) const {
    return std::sqrt((sum_ + (all - known_) * std::pow(kUnknown * cap_, 2)) / all);
  }

 private:
  static constexpr double kCap = 0.05;     // of the size; chosen
  static constexpr double kUnknown = 0.3;  // of the cap; chosen
  double cap_;
  double sum_ = 0;
  double known_ = 0;
};

}  // namespace tool_path_stretcher
