// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/checkerboard.h"

#include <algorithm>
#include <cmath>

namespace scan_cell_sim {
namespace {

constexpr double kFar = 5;  // standard deviations beyond which a blurred edge is invisible; chosen

/// An edge from -1 to 1 at 0, blurred.
double edge(double x, double blur) {
  if (std::abs(x) > kFar * blur) return std::copysign(1, x);
  return std::erf(x * M_SQRT1_2 / blur);
}

/// A wave that changes sign at 0, `size`, 2 `size` .. (count - 1) `size` and is 1 after the first,
/// blurred. Only the nearest edge counts, as the blur is small compared with a square.
double wave(double x, double size, int count, double blur) {
  const double nearest = std::clamp(std::round(x / size), 0.0, count - 1.0);
  const double rising = std::fmod(nearest, 2) == 0 ? 1 : -1;
  return rising * edge(x - nearest * size, blur);
}

}  // namespace

double Checkerboard::reflectance(const Eigen::Vector2d& point, const Eigen::Vector2d& blur) const {
  const Eigen::Array2i corners(columns, rows);
  double within = 1;
  double sign = 1;
  for (const int axis : {0, 1}) {
    const double end = corners[axis] * square_size;
    within *= (1 + edge(point[axis] + square_size, blur[axis])) / 2;
    within *= (1 + edge(end - point[axis], blur[axis])) / 2;
    sign *= wave(point[axis], square_size, corners[axis], blur[axis]);
  }
  return white + (black - white) * within * (1 + sign) / 2;
}

Mesh Checkerboard::mesh() const {
  const double before = square_size + margin;
  const double x = columns * square_size + margin;
  const double y = rows * square_size + margin;
  Mesh mesh{{{-before, -before, 0}, {x, -before, 0}, {x, y, 0}, {-before, y, 0}},
            {{0, 2, 1}, {0, 3, 2}}};
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex = pose * vertex;
  return mesh;
}

}  // namespace scan_cell_sim
