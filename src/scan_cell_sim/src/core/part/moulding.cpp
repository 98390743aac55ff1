// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "part/moulding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scan_cell_sim {
namespace {

using Eigen::Vector2d;

struct Corner {
  double x;       // [m] inwards from the outer edge
  double height;  // [m]
  double radius;  // [m] of its rounding
};

// Chosen.
constexpr std::array<Corner, 10> kCorners = {{{0.000, 0.000, 0},
                                              {0.000, 0.009, 0.0025},
                                              {0.004, 0.009, 0.0012},
                                              {0.007, 0.020, 0.0040},
                                              {0.013, 0.020, 0.0040},
                                              {0.016, 0.012, 0.0020},
                                              {0.021, 0.010, 0.0020},
                                              {0.025, 0.004, 0.0020},
                                              {0.028, 0.004, 0.0010},
                                              {0.028, 0.000, 0}}};
constexpr std::size_t kCrestRun = 3;  // from corner 3 to corner 4

Vector2d place(std::size_t corner) {
  return {kCorners[corner].x, kCorners[corner].height};
}

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

Moulding::Moulding() : width_(kCorners.back().x) {
  Vector2d begin = place(0);
  for (std::size_t i = 1; i < kCorners.size(); ++i) {
    Run run{begin, place(i), Vector2d::Zero(), kCorners[i].radius, 0, 0};
    if (i + 1 < kCorners.size()) {
      const Vector2d in = (place(i) - place(i - 1)).normalized();
      const Vector2d out = (place(i + 1) - place(i)).normalized();
      run.arc_sweep = std::atan2(cross(in, out), in.dot(out));
      const double cut = run.arc_radius * std::tan(std::abs(run.arc_sweep) / 2);
      const double side = run.arc_sweep > 0 ? 1 : -1;
      const Vector2d to_centre = side * Vector2d(-in.y(), in.x());
      run.end = place(i) - cut * in;
      run.arc_centre = run.end + run.arc_radius * to_centre;
      run.arc_begin = std::atan2(-to_centre.y(), -to_centre.x());
      begin = place(i) + cut * out;
    }
    runs_.push_back(run);
  }
  crest_ = (runs_[kCrestRun].begin + runs_[kCrestRun].end) / 2;
}

std::vector<Vector2d> Moulding::points(double step, double tolerance) const {
  std::vector<Vector2d> result;
  for (const Run& run : runs_) {
    const double length = (run.end - run.begin).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int i = 0; i < pieces; ++i) {
      result.push_back(run.begin + (run.end - run.begin) * i / pieces);
    }
    if (run.arc_radius == 0) continue;
    const double sagitta = std::min(tolerance / run.arc_radius, 1.0);
    const double turn = std::min(2 * std::acos(1 - sagitta), step / run.arc_radius);
    const int turns = std::max(1, static_cast<int>(std::ceil(std::abs(run.arc_sweep) / turn)));
    for (int i = 0; i < turns; ++i) {
      const double angle = run.arc_begin + run.arc_sweep * i / turns;
      result.push_back(run.arc_centre +
                       run.arc_radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
  }
  const int pieces = std::max(1, static_cast<int>(std::ceil(width_ / step)));
  for (int i = 0; i <= pieces; ++i)
    result.emplace_back(width_ * (pieces - i) / pieces, 0);  // the underside
  return result;
}

}  // namespace scan_cell_sim
