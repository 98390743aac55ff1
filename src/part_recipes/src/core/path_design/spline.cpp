// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/spline.h"

#include <array>
#include <cmath>

namespace part_recipes {

using Eigen::Vector3d;

Vector3d CatmullRom::point(std::ptrdiff_t i) const {
  const auto count = static_cast<std::ptrdiff_t>(points_.size());
  const auto at = [this](std::ptrdiff_t k) { return points_[static_cast<std::size_t>(k)]; };
  if (closed_) return at((i + count) % count);
  if (i < 0) return 2 * at(0) - at(1);
  if (i >= count) return 2 * at(count - 1) - at(count - 2);
  return at(i);
}

Vector3d CatmullRom::at(std::size_t piece, double share) const {
  // Barry and Goldman's pyramid (1988): the knots are spaced by the square roots of the distances.
  std::array<Vector3d, 4> p;
  std::array<double, 4> knot{};
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = point(static_cast<std::ptrdiff_t>(piece + i) - 1);
    if (i > 0) knot[i] = knot[i - 1] + std::sqrt((p[i] - p[i - 1]).norm());
  }
  const double t = knot[1] + share * (knot[2] - knot[1]);
  for (std::size_t level = 1; level <= 3; ++level) {
    for (std::size_t i = 0; i + level <= 3; ++i) {
      // The last level is between the two middle knots.
      const std::size_t low = level == 3 ? 1 : i, high = level == 3 ? 2 : i + level;
      const double part = (t - knot[low]) / (knot[high] - knot[low]);
      p[i] = (1 - part) * p[i] + part * p[i + 1];
    }
  }
  return p[0];
}

}  // namespace part_recipes
