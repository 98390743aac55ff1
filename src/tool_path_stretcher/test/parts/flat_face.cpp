// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parts/flat_face.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cases {
namespace {

using Eigen::Vector2d;
using Ring = std::vector<std::size_t>;
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

/// Triangulates in the plane: joins the holes to the outline by bridges, then cuts off ears.
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

  FlatFace face() const { return {points_, rings_, triangles_}; }

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

  /// Whether a point lies in the open angle of the ring at one of its corners.
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

FlatFace triangulated(const Loop& outline, const std::vector<Loop>& holes) {
  return Triangulation(outline, holes).face();
}

}  // namespace cases
