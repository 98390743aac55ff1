// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parts/solids.h"

#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "parts/flat_face.h"

namespace cases {

using Eigen::Vector2d;

Loop star(int points, double outer, double inner) {
  Loop loop;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = M_PI * i / points;
    loop.push_back((i % 2 == 0 ? outer : inner) * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return loop;
}

Loop regular(int corners, double radius) {
  return circle(Vector2d::Zero(), radius, corners);
}

Loop rectangle_loop(double width, double depth) {
  return {{width / 2, -depth / 2},
          {width / 2, depth / 2},
          {-width / 2, depth / 2},
          {-width / 2, -depth / 2}};
}

Loop circle(const Vector2d& centre, double radius, int corners) {
  Loop loop;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    loop.push_back(centre + radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return loop;
}

Loop cross(double length, double width) {
  const double l = length / 2, w = width / 2;
  return {{l, -w}, {l, w},   {w, w},   {w, l},   {-w, l}, {-w, w},
          {-l, w}, {-l, -w}, {-w, -w}, {-w, -l}, {w, -l}, {w, -w}};
}

bool is_inside(const Loop& loop, const Vector2d& at) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector2d &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a.y() > at.y()) == (b.y() > at.y())) continue;
    if (at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

double distance_to(const Loop& loop, const Vector2d& at) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector2d& from = loop[i];
    const Vector2d way = loop[(i + 1) % loop.size()] - from;
    const double share = std::clamp(way.dot(at - from) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (from + share * way - at).norm());
  }
  return least;
}

pcl::PolygonMesh mesh_of(const Solid& solid) {
  const FlatFace flat = triangulated(solid.outline, solid.holes);
  const std::size_t count = flat.points.size();
  pcl::PointCloud<pcl::PointXYZ> vertices;
  const auto add = [&vertices](const Vector2d& at, double z) {
    vertices.push_back(
        {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(z)});
  };
  for (const Vector2d& point : flat.points)
    add(point, 0);
  for (const Vector2d& point : flat.points)
    add(solid.taper * point, solid.height);
  pcl::PolygonMesh mesh;
  const auto triangle = [&mesh](std::size_t a, std::size_t b, std::size_t c) {
    mesh.polygons.emplace_back();
    for (const std::size_t corner : {a, b, c})
      mesh.polygons.back().vertices.push_back(static_cast<pcl::index_t>(corner));
  };
  for (const auto& [a, b, c] : flat.triangles) {
    triangle(c, b, a);
    triangle(count + a, count + b, count + c);
  }
  for (const std::vector<std::size_t>& ring : flat.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t a = ring[i], b = ring[(i + 1) % ring.size()];
      triangle(a, b, count + b);
      triangle(a, count + b, count + a);
    }
  }
  pcl::toPCLPointCloud2(vertices, mesh.cloud);
  return mesh;
}

}  // namespace cases
