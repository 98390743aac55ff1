// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parts/solids.h"

#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cases {
namespace {

using Eigen::Vector2d;
using Ring = std::vector<std::size_t>;  // corners by their number
using Corners = std::array<std::size_t, 3>;

double cross_of(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double area_of(const Loop& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += cross_of(loop[i], loop[(i + 1) % loop.size()]) / 2;
  return sum;
}

bool cross_each_other(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const auto side = [](const Vector2d& from, const Vector2d& to, const Vector2d& at) {
    return cross_of(to - from, at - from);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Triangles of the plane: the holes are joined to the outline by bridges, then ears are cut off.
class Triangulation {
 public:
  Triangulation(const Loop& outline, const std::vector<Loop>& holes) {
    add(outline, true);
    for (const Loop& hole : holes)
      add(hole, false);
    ring_ = rings_.front();
    std::vector<Ring> left(rings_.begin() + 1, rings_.end());
    std::stable_sort(left.begin(), left.end(), [this](const Ring& a, const Ring& b) {
      return points_[rightmost(a)].x() > points_[rightmost(b)].x();
    });
    for (const Ring& hole : left)
      bridge(hole);
    while (ring_.size() > 3)
      cut_ear();
    triangles_.push_back({ring_[0], ring_[1], ring_[2]});
  }

  const Loop& points() const { return points_; }
  const std::vector<Ring>& rings() const { return rings_; }
  const std::vector<Corners>& triangles() const { return triangles_; }

 private:
  void add(Loop loop, bool left_turning) {
    if ((area_of(loop) > 0) != left_turning) std::reverse(loop.begin(), loop.end());
    rings_.emplace_back();
    for (const Vector2d& point : loop) {
      rings_.back().push_back(points_.size());
      points_.push_back(point);
    }
  }

  std::size_t rightmost(const Ring& ring) const {
    return *std::max_element(ring.begin(), ring.end(), [this](std::size_t a, std::size_t b) {
      return points_[a].x() < points_[b].x();
    });
  }

  bool is_free(const Vector2d& from, const Vector2d& to) const {
    for (const Ring& ring : rings_) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        if (cross_each_other(from, to, points_[ring[i]], points_[ring[(i + 1) % ring.size()]]))
          return false;
      }
    }
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (cross_each_other(from, to, points_[ring_[i]], points_[ring_[(i + 1) % ring_.size()]]))
        return false;
    }
    return true;
  }

  void bridge(const Ring& hole) {
    const std::size_t start = rightmost(hole);
    std::size_t best = ring_.size();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const double away = (points_[ring_[i]] - points_[start]).norm();
      if (away >= nearest || !opens_to(i, points_[start])) continue;
      if (!is_free(points_[ring_[i]], points_[start])) continue;
      nearest = away;
      best = i;
    }
    if (best == ring_.size()) throw std::logic_error("a hole crosses the outline");
    Ring joined(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(best) + 1);
    const auto first = std::find(hole.begin(), hole.end(), start);
    joined.insert(joined.end(), first, hole.end());
    joined.insert(joined.end(), hole.begin(), first + 1);
    joined.insert(joined.end(), ring_.begin() + static_cast<std::ptrdiff_t>(best), ring_.end());
    ring_ = std::move(joined);
  }

  /// Whether a point lies in the angle that the ring leaves open at one of its corners.
  bool opens_to(std::size_t i, const Vector2d& at) const {
    const Vector2d& corner = points_[ring_[i]];
    const Vector2d before = points_[ring_[(i + ring_.size() - 1) % ring_.size()]] - corner;
    const Vector2d after = points_[ring_[(i + 1) % ring_.size()]] - corner;
    const Vector2d way = at - corner;
    const auto angle = [](const Vector2d& from, const Vector2d& to) {
      const double turn = std::atan2(cross_of(from, to), from.dot(to));
      return turn <= 0 ? turn + 2 * M_PI : turn;
    };
    return angle(after, way) < angle(after, before);
  }

  void cut_ear() {
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Corners ear = {ring_[(i + ring_.size() - 1) % ring_.size()], ring_[i],
                           ring_[(i + 1) % ring_.size()]};
      if (!is_ear(ear)) continue;
      triangles_.push_back(ear);
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
      return;
    }
    throw std::logic_error("a loop crosses itself");
  }

  bool is_ear(const Corners& ear) const {
    constexpr double kFlat = 1e-12;  // [m^2]
    const Vector2d &a = points_[ear[0]], &b = points_[ear[1]], &c = points_[ear[2]];
    if (cross_of(b - a, c - a) < kFlat) return false;
    return std::none_of(ring_.begin(), ring_.end(), [&](std::size_t other) {
      const Vector2d& at = points_[other];
      if (at == a || at == b || at == c) return false;
      return cross_of(b - a, at - a) >= 0 && cross_of(c - b, at - b) >= 0 &&
             cross_of(a - c, at - c) >= 0;
    });
  }

  Loop points_;
  std::vector<Ring> rings_;
  Ring ring_;
  std::vector<Corners> triangles_;
};

}  // namespace

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
  const Triangulation flat(solid.outline, solid.holes);
  const std::size_t count = flat.points().size();
  pcl::PointCloud<pcl::PointXYZ> vertices;
  const auto add = [&vertices](const Vector2d& at, double z) {
    vertices.push_back(
        {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(z)});
  };
  for (const Vector2d& point : flat.points())
    add(point, 0);
  for (const Vector2d& point : flat.points())
    add(solid.taper * point, solid.height);
  pcl::PolygonMesh mesh;
  const auto triangle = [&mesh](std::size_t a, std::size_t b, std::size_t c) {
    mesh.polygons.emplace_back();
    for (const std::size_t corner : {a, b, c})
      mesh.polygons.back().vertices.push_back(static_cast<pcl::index_t>(corner));
  };
  for (const auto& [a, b, c] : flat.triangles()) {
    triangle(c, b, a);
    triangle(count + a, count + b, count + c);
  }
  for (const Ring& ring : flat.rings()) {
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
