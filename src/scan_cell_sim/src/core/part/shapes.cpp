// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "part/moulding.h"

namespace scan_cell_sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLongestStep = 0.005;  // [m] chosen: humps reach further (deformation.cpp)

/// Cuts patches of surface into triangles.
class Tessellator {
 public:
  Tessellator(const Deformation& deformation, double tolerance)
      : deformation_(deformation), tolerance_(tolerance) {}

  /// Longest edge [m] at a surface of this curvature: a triangle with legs L on a surface of
  /// curvature c is at most 2 c L^2 / 8 from it.
  double step(double curvature) const {
    return curvature > 0 ? std::min(std::sqrt(4 * tolerance_ / curvature), kLongestStep)
                         : kLongestStep;
  }

  double curvature(const Vector3d& point) const { return deformation_.curvature_bound(point); }

  /// Fractions 0 .. 1 of a way of `length` [m], as close as the curvature at each demands.
  std::vector<double> stations(double length,
                               const std::function<double(double)>& curvature_at) const {
    std::vector<double> result = {0};
    while (result.back() < 1) {
      const double ahead =
          std::min(1.0, result.back() + step(curvature_at(result.back())) / length);
      const double wanted =
          std::min(step(curvature_at(result.back())), step(curvature_at(ahead))) / length;
      result.push_back(std::min(1.0, result.back() + wanted));
    }
    return result;
  }

  /// A grid of points, rows x columns; row direction x column direction points outwards.
  void add_grid(std::size_t rows, std::size_t columns,
                const std::function<Vector3d(std::size_t, std::size_t)>& point) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < columns; ++c)
        mesh_.vertices.push_back(point(r, c));
    }
    const auto at = [&](std::size_t r, std::size_t c) {
      return first + static_cast<std::uint32_t>(r * columns + c);
    };
    for (std::size_t r = 0; r + 1 < rows; ++r) {
      for (std::size_t c = 0; c + 1 < columns; ++c) {
        mesh_.triangles.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1)});
        mesh_.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r, c + 1)});
      }
    }
  }

  /// A parallelogram origin + s u + t v, seen from the side u x v; `lift` shifts its points and has
  /// no larger second derivative than `lift_curvature`.
  void add_patch(const Vector3d& origin, const Vector3d& u, const Vector3d& v,
                 const std::function<Vector3d(double, double)>& lift = nullptr,
                 double lift_curvature = 0) {
    const auto along = [&](const Vector3d& way, const Vector3d& across) {
      return stations(way.norm(), [&](double s) {
        return lift_curvature + max_curvature(origin + s * way, across);
      });
    };
    const std::vector<double> us = along(u, v);
    const std::vector<double> vs = along(v, u);
    add_grid(us.size(), vs.size(), [&](std::size_t i, std::size_t j) -> Vector3d {
      const Vector3d flat = origin + us[i] * u + vs[j] * v;
      return lift ? Vector3d(flat + lift(us[i], vs[j])) : flat;
    });
  }

  void add_box(const Vector3d& least, const Vector3d& most) {
    const Vector3d x = Vector3d::UnitX() * (most.x() - least.x());
    const Vector3d y = Vector3d::UnitY() * (most.y() - least.y());
    const Vector3d z = Vector3d::UnitZ() * (most.z() - least.z());
    add_patch(least + z, x, y);
    add_patch(least, y, x);
    add_patch(least, x, z);
    add_patch(least, z, y);
    add_patch(least + x, y, z);
    add_patch(least + y, z, x);
  }

  Mesh take() { return std::move(mesh_); }

 private:
  double max_curvature(const Vector3d& begin, const Vector3d& way) const {
    const int samples = static_cast<int>(std::ceil(way.norm() / kLongestStep)) + 1;
    double most = 0;
    for (int i = 0; i <= samples; ++i) {
      most = std::max(most, curvature(begin + way * i / samples));
    }
    return most;
  }

  const Deformation& deformation_;
  double tolerance_;
  Mesh mesh_;
};

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
