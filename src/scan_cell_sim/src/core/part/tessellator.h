// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "scan_cell_sim/shapes.h"

namespace scan_cell_sim {

constexpr double kLongestStep = 0.005;  // [m] a hump reaches further than this (deformation.cpp)

/// Cuts patches of surface into triangles.
class Tessellator {
 public:
  Tessellator(const Deformation& deformation, double tolerance)
      : deformation_(deformation), tolerance_(tolerance) {}

  /// Longest edge [m] at a surface of this curvature: a triangle with legs L on a surface of
  /// curvature c is at most 2 c L^2 / 8 off it.
  double step(double curvature) const {
    return curvature > 0 ? std::min(std::sqrt(4 * tolerance_ / curvature), kLongestStep)
                         : kLongestStep;
  }

  double curvature(const Eigen::Vector3d& point) const {
    return deformation_.curvature_bound(point);
  }

  /// Fractions 0 .. 1 of a way of `length` [m], as close as the curvature at each requires.
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
                const std::function<Eigen::Vector3d(std::size_t, std::size_t)>& point) {
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

  /// A parallelogram origin + s u + t v, seen from the side u x v. `lift` shifts its points; its
  /// second derivatives are at most `lift_curvature`.
  void add_patch(const Eigen::Vector3d& origin, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
                 const std::function<Eigen::Vector3d(double, double)>& lift = nullptr,
                 double lift_curvature = 0) {
    const auto along = [&](const Eigen::Vector3d& way, const Eigen::Vector3d& across) {
      return stations(way.norm(), [&](double s) {
        return lift_curvature + max_curvature(origin + s * way, across);
      });
    };
    const std::vector<double> us = along(u, v);
    const std::vector<double> vs = along(v, u);
    add_grid(us.size(), vs.size(), [&](std::size_t i, std::size_t j) -> Eigen::Vector3d {
      const Eigen::Vector3d flat = origin + us[i] * u + vs[j] * v;
      return lift ? Eigen::Vector3d(flat + lift(us[i], vs[j])) : flat;
    });
  }

  void add_box(const Eigen::Vector3d& least, const Eigen::Vector3d& most) {
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX() * (most.x() - least.x());
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY() * (most.y() - least.y());
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ() * (most.z() - least.z());
    add_patch(least + z, x, y);
    add_patch(least, y, x);
    add_patch(least, x, z);
    add_patch(least, z, y);
    add_patch(least + x, y, z);
    add_patch(least + y, z, x);
  }

  /// A flat round disc, seen from the side across x along.
  /// @param across, along orthogonal, of the disc's radius [m]
  void add_disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& across,
                const Eigen::Vector3d& along) {
    const double radius = across.norm();
    const auto rings = static_cast<std::size_t>(std::ceil(radius / kLongestStep));
    const std::size_t sectors = sectors_of(radius);
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back(centre);
    add_grid(rings, sectors + 1, [&](std::size_t ring, std::size_t sector) -> Eigen::Vector3d {
      const double share = static_cast<double>(ring + 1) / static_cast<double>(rings);
      return centre + share * on_circle(across, along, sector, sectors);
    });
    for (std::size_t i = 0; i < sectors; ++i) {
      const auto rim = first + 1 + static_cast<std::uint32_t>(i);
      mesh_.triangles.push_back({first, rim, rim + 1});
    }
  }

  /// Number of sectors of a circle of this radius [m], if a deformation bends it as well.
  std::size_t sectors_of(double radius, double curvature_besides = 0) const {
    const double longest = step(1 / radius + curvature_besides);
    return static_cast<std::size_t>(std::ceil(2 * M_PI * radius / longest));
  }

  /// A point of the circle through across and along, from its centre.
  static Eigen::Vector3d on_circle(const Eigen::Vector3d& across, const Eigen::Vector3d& along,
                                   std::size_t sector, std::size_t sectors) {
    const double angle =
        2 * M_PI * static_cast<double>(sector % sectors) / static_cast<double>(sectors);
    return std::cos(angle) * across + std::sin(angle) * along;
  }

  Mesh take() { return std::move(mesh_); }

 private:
  double max_curvature(const Eigen::Vector3d& begin, const Eigen::Vector3d& way) const {
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

}  // namespace scan_cell_sim
