// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parts/part.h"

#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <cmath>

#include "parts/shapes.h"

namespace cases {
namespace {

/// @param profile height across the moulding, from 0 at the outer rim to 1
Part frame(const std::function<double(double across)>& profile, double rosette, double crest) {
  constexpr double kWidth = 0.200;
  constexpr double kDepth = 0.150;
  constexpr double kMoulding = 0.025;
  const auto from_rim = [](double x, double y) {
    return std::min(kWidth / 2 - std::abs(x), kDepth / 2 - std::abs(y));
  };
  const Height height = [=](double x, double y) {
    const double away = std::hypot(x - 0.055, y - 0.0625) / 0.006;
    return profile(from_rim(x, y) / kMoulding) + rosette * std::exp(-away * away);
  };
  const Inside inside = [=](double x, double y) { return from_rim(x, y) <= kMoulding; };
  Part part;
  part.size = half_diagonal(kWidth, kDepth);
  part.facets = facets_of(kWidth, kDepth, inside, height, true);
  part.path = path_along([=](double a) {
    const double inwards = crest * kMoulding;
    const Eigen::Vector2d at = around(kWidth / 2 - inwards, kDepth / 2 - inwards, a);
    return top_at(height, at.x(), at.y());
  });
  return part;
}

Part panel(const Height& height) {
  Part part;
  part.size = half_diagonal(0.3, 0.2);
  part.facets = facets_of(
      0.3, 0.2, [](double, double) { return true; }, height, false);
  part.path = path_along(
      [height](double a) { return top_at(height, -0.12 + 0.24 * a, 0.06 * std::sin(9 * a)); });
  return part;
}

constexpr double kBoxWidth = 0.180;
constexpr double kBoxDepth = 0.120;
constexpr double kBoxHeight = 0.060;

Part box_of(const Height& height, const std::function<SurfacePoint(double a)>& path) {
  Part part;
  part.size = half_diagonal(kBoxWidth, kBoxDepth);
  part.facets = facets_of(
      kBoxWidth, kBoxDepth, [](double, double) { return true; }, height, true);
  part.path = path_along(path);
  return part;
}

}  // namespace

Part photo_frame(double rosette) {
  return frame(
      [](double across) {
        return 0.006 + 0.014 * std::pow(std::sin(M_PI * (0.15 + 0.7 * across)), 2);
      },
      rosette, 0.4);
}

Part other_frame() {
  return frame(
      [](double across) {
        return 0.005 + 0.010 * std::pow(std::sin(M_PI * (0.05 + 0.6 * across)), 2) + 0.006 * across;
      },
      0.003, 0.4);
}

Part box(bool pocket) {
  const Height height = [pocket](double x, double y) {
    return kBoxHeight - (pocket && x > 0.030 && y > 0.020 ? 0.006 : 0.0);
  };
  return box_of(height, [](double a) {
    const double s = -0.06 + 0.14 * a;  // over the lid, and from x = 0.03 at y = -0.06 down
    if (s < 0.03)
      return SurfacePoint{{s, -0.02 - 0.04 * (s + 0.06) / 0.09, kBoxHeight},
                          Eigen::Vector3d::UnitZ()};
    return SurfacePoint{{0.03, -kBoxDepth / 2, kBoxHeight - (s - 0.03)}, -Eigen::Vector3d::UnitY()};
  });
}

Part box_with_loop() {
  return box_of([](double, double) { return kBoxHeight; },
                [](double a) {
                  const Eigen::Vector2d at = around(0.07, 0.04, a);
                  return SurfacePoint{{at.x(), at.y(), kBoxHeight}, Eigen::Vector3d::UnitZ()};
                });
}

Part curved_panel() {
  return panel([](double x, double y) {
    return 1.2 * x * x - 0.8 * y * y + 4 * x * x * x + 0.5 * x * y + 3 * y * y * x +
           0.004 * std::sin(25 * x + 1) * std::cos(20 * y);
  });
}

Part other_panel() {
  return panel([](double x, double y) {
    return 0.7 * x * x + 0.9 * y * y - 5 * x * x * y + 0.005 * std::cos(30 * x) * std::sin(28 * y);
  });
}

Part straight_moulding() {
  constexpr double kWidth = 0.240;
  constexpr double kDepth = 0.050;
  const Height height = [](double, double y) {
    const double across = std::pow(y / kDepth + 0.5, 1.8);
    return 0.006 + 0.014 * std::pow(std::sin(M_PI * (0.15 + 0.7 * across)), 2);
  };
  Part part;
  part.size = half_diagonal(kWidth, kDepth);
  part.facets = facets_of(
      kWidth, kDepth, [](double, double) { return true; }, height, true);
  part.path = path_along([height](double a) { return top_at(height, -0.09 + 0.18 * a, -0.005); });
  return part;
}

Part cup() {
  constexpr double kSteps = 720;
  constexpr double kHigh = 0.10;
  const auto radius = [](double v) { return 0.045 + 0.015 * v - 0.006 * std::sin(M_PI * v); };
  const auto at = [radius](double angle, double v) {
    const double slope = (radius(v + kStep) - radius(v - kStep)) / (2 * kStep * kHigh);
    return SurfacePoint{{radius(v) * std::cos(angle), radius(v) * std::sin(angle), kHigh * v},
                        Eigen::Vector3d(std::cos(angle), std::sin(angle), -slope).normalized()};
  };
  Part part;
  part.size = 0.06;
  for (int i = 0; i < kSteps; ++i) {
    const double from = 2 * M_PI * i / kSteps;
    constexpr double kWide = 2 * M_PI / kSteps;
    part.facets.push_back(
        {kWide * 0.05 * kHigh, [=](double u, double v) { return at(from + u * kWide, v); }});
  }
  part.path = path_along([at](double a) { return at(0.3, 0.1 + 0.8 * a); });
  return part;
}

Part part_of_mesh(const pcl::PolygonMesh& mesh, const ToolPath& path) {
  pcl::PointCloud<pcl::PointXYZ> vertices;
  pcl::fromPCLPointCloud2(mesh.cloud, vertices);
  Part part;
  part.path = path;
  Eigen::AlignedBox3d extent;
  for (const pcl::Vertices& polygon : mesh.polygons) {
    const auto corner = [&](std::size_t i) {
      return vertices[static_cast<std::size_t>(polygon.vertices[i])]
          .getVector3fMap()
          .cast<double>()
          .eval();
    };
    const Eigen::Vector3d a = corner(0), b = corner(1), c = corner(2);
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    extent.extend(a);
    if (normal.isZero()) continue;
    part.facets.push_back(
        {normal.norm() / 2, [=](double u, double v) {
           const double root = std::sqrt(u);
           return SurfacePoint{(1 - root) * a + root * ((1 - v) * b + v * c), normal.normalized()};
         }});
  }
  part.size = extent.diagonal().norm() / 2;
  return part;
}

}  // namespace cases
