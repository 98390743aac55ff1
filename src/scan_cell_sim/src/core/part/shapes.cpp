// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/shapes.h"

#include <algorithm>
#include <cmath>

#include "part/elbow.h"
#include "part/moulding.h"
#include "part/tessellator.h"

namespace scan_cell_sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// One of the four mitred sides of a ring, along `tangent`, outside at `outward`.
struct Side {
  Vector3d outward;
  Vector3d tangent;
  double half_depth;   // [m] centre of the frame to the side's outer edge
  double half_length;  // [m] of the outer edge

  Vector3d point(double fraction, const Vector2d& section) const {
    return outward * (half_depth - section.x()) +
           tangent * (2 * fraction - 1) * (half_length - section.x()) +
           Vector3d::UnitZ() * section.y();
  }
};

void add_side(const Side& side, Tessellator& tessellator, double tolerance) {
  // Sections a few millimetres apart decide how finely the side is cut along and across.
  const std::vector<Vector2d> coarse = Moulding().points(kLongestStep, kLongestStep);
  double finest = kLongestStep;
  const auto curvature_at = [&](double fraction) {
    double most = 0;
    for (const Vector2d& section : coarse) {
      most = std::max(most, tessellator.curvature(side.point(fraction, section)));
    }
    finest = std::min(finest, tessellator.step(most));
    return most;
  };
  const std::vector<double> along = tessellator.stations(2 * side.half_length, curvature_at);
  const std::vector<Vector2d> across = Moulding().points(finest, tolerance);
  tessellator.add_grid(along.size(), across.size(), [&](std::size_t i, std::size_t j) {
    return side.point(along[i], across[j]);
  });
}

void add_sheet(const FrameShape& frame, Tessellator& tessellator) {
  const Vector2d opening = frame.size - Vector2d::Constant(2 * Moulding().width());
  const Vector3d corner(-opening.x() / 2, -opening.y() / 2, frame.sheet->height);
  const double bulge = frame.sheet->bulge;
  const auto lift = [bulge](double s, double t) -> Vector3d {
    const double x = 4 * s * (1 - s);
    const double y = 4 * t * (1 - t);
    return Vector3d::UnitZ() * bulge * x * x * y * y;
  };
  // With x = 1 - r^2, the second derivative of x^2 is at most 8 over the squared half width.
  const double curvature = 4 * 8 * std::abs(bulge) / std::pow(opening.minCoeff(), 2);
  tessellator.add_patch(corner, Vector3d::UnitX() * opening.x(), Vector3d::UnitY() * opening.y(),
                        lift, curvature);
}

void add(const FrameShape& frame, Tessellator& tessellator, double tolerance) {
  const double x = frame.size.x() / 2;
  const double y = frame.size.y() / 2;
  for (const Side& side : {Side{Vector3d::UnitX(), Vector3d::UnitY(), x, y},
                           Side{Vector3d::UnitY(), -Vector3d::UnitX(), y, x},
                           Side{-Vector3d::UnitX(), -Vector3d::UnitY(), x, y},
                           Side{-Vector3d::UnitY(), Vector3d::UnitX(), y, x}}) {
    add_side(side, tessellator, tolerance);
  }
  const Hanger hanger = hanger_of(frame);
  tessellator.add_box(hanger.least, hanger.most);
  if (frame.sheet) add_sheet(frame, tessellator);
}

void add(const BoxShape& box, Tessellator& tessellator, double) {
  const Vector3d half(box.size.x() / 2, box.size.y() / 2, 0);
  tessellator.add_box(-half, half + Vector3d::UnitZ() * box.size.z());
}

void add(const ElbowShape& elbow, Tessellator& tessellator, double) {
  add_elbow(elbow, tessellator);
}

}  // namespace

Hanger hanger_of(const FrameShape& frame) {
  // It starts inside the outer wall, below the wall's upper edge; [m] chosen.
  const double x = frame.size.x() / 2;
  const double y = frame.size.y() / 2;
  return {{x - 0.002, y - 0.045, 0}, {x + 0.010, y - 0.015, 0.007}};
}

Mesh tessellate(const Shape& shape, const Deformation& deformation, double tolerance) {
  // Half of the tolerance for the shape's own arcs, half for the deformation.
  Tessellator tessellator(deformation, tolerance / 2);
  std::visit([&](const auto& s) { add(s, tessellator, tolerance / 2); }, shape);
  return tessellator.take();
}

}  // namespace scan_cell_sim
