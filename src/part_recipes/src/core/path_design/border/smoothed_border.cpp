// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "path_design/border/border.h"

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

struct Line {
  Vector3d point;      // [m]
  Vector3d direction;  // unit length, onwards
};

/// A closed line, measured by length from its first point.
class Loop {
 public:
  explicit Loop(const Trace& border) {
    for (const TracePoint& point : border.points)
      positions_.push_back(point.position);
    even_out();
    double at = 0;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      if (i > 0) at += (positions_[i] - positions_[i - 1]).norm();
      arc_.push_back(at);
    }
    length_ = at + (positions_.front() - positions_.back()).norm();
  }

  std::size_t size() const { return positions_.size(); }
  double length() const { return length_; }
  const Vector3d& position(std::size_t i) const { return positions_[i]; }

  /// [m] from one point to another, the short way: below 0 backwards
  double ahead(std::size_t from, std::size_t to) const {
    return std::remainder(arc_[to] - arc_[from], length_);
  }

  /// Calls visit(j, distance) for the points within a reach [m] before (-1) or behind (1) one.
  template <class Visit>
  void along(std::size_t from, int direction, double reach, const Visit& visit) const {
    const std::size_t step = direction > 0 ? 1 : size() - 1;
    for (std::size_t k = 1; k < size(); ++k) {
      const std::size_t j = (from + k * step) % size();
      const double distance = ahead(from, j) * direction;
      if (distance < 0 || distance > reach || !visit(j, distance)) return;
    }
  }

 private:
  /// The points of a cloud's border zigzag, which would make it too long.
  void even_out() {
    constexpr int kRounds = 2;  // chosen: each about the mean of a point and its neighbours
    for (int round = 0; round < kRounds; ++round) {
      const std::vector<Vector3d> old = positions_;
      for (std::size_t i = 0; i < old.size(); ++i)
        positions_[i] =
            old[i] / 2 + (old[(i + old.size() - 1) % old.size()] + old[(i + 1) % old.size()]) / 4;
    }
  }

  std::vector<Vector3d> positions_;
  std::vector<double> arc_;
  double length_ = 0;
};

/// The line through points (total least squares).
std::optional<Line> line_through(const std::vector<Vector3d>& points, int direction) {
  if (points.size() < 2) return std::nullopt;
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& point : points)
    mean += point / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& point : points)
    spread += (point - mean) * (point - mean).transpose();
  Vector3d along = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
  const Vector3d onwards = direction * (points.back() - points.front());
  if (along.dot(onwards) < 0) along = -along;
  return Line{mean, along};
}

class Smoothing {
 public:
  Smoothing(const Trace& border, double reach, double corner_angle, const MeshSearch& surface)
      : border_(border), loop_(border), reach_(reach), angle_(corner_angle), surface_(surface) {}

  Trace run() {
    find_corners();
    Trace result;
    result.closed = true;
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const Vector3d position = corner_[i] ? *corner_[i] : smooth(i);
      const Foot foot = surface_.nearest(position);
      // Sideways the line stays as fitted; the surface gives its height.
      const Vector3d on = position - (position - foot.point).dot(foot.normal) * foot.normal;
      result.points.push_back({on, foot.normal, corner_[i].has_value()});
    }
    return result;
  }

 private:
  /// The straight line before (-1) or behind (1) a point, without the points next to it, where
  /// edges are blunt.
  std::optional<Line> side(std::size_t i, int direction) const {
    constexpr double kBlunt = 0.4;  // of the reach; chosen
    constexpr double kLong = 2.2;   // of the reach; chosen
    std::vector<Vector3d> points;
    loop_.along(i, direction, kLong * reach_, [&](std::size_t j, double distance) {
      if (distance > kBlunt * reach_) points.push_back(loop_.position(j));
      return true;
    });
    return line_through(points, direction);
  }

  double turn(std::size_t i) const {
    const auto before = side(i, -1), behind = side(i, 1);
    if (!before || !behind) return 0;
    return std::acos(std::clamp(before->direction.dot(behind->direction), -1.0, 1.0));
  }

  std::size_t at_distance(std::size_t i, int direction, double distance) const {
    std::size_t found = i;
    loop_.along(i, direction, distance, [&](std::size_t j, double) {
      found = j;
      return true;
    });
    return found;
  }

  /// A corner turns more than all points near it, and more than twice as much as the line beside
  /// it: an arc turns everywhere.
  void find_corners() {
    constexpr double kBeside = 2.6;  // of the reach: beyond the lines; chosen
    constexpr double kArc = 2;       // chosen
    corner_.assign(loop_.size(), std::nullopt);
    if (loop_.length() < 10 * reach_) return;  // too short to tell corners from noise
    std::vector<double> turns;
    for (std::size_t i = 0; i < loop_.size(); ++i)
      turns.push_back(turn(i));
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      if (turns[i] < angle_ || !is_peak(turns, i)) continue;
      const double beside = std::max(turns[at_distance(i, -1, kBeside * reach_)],
                                     turns[at_distance(i, 1, kBeside * reach_)]);
      if (turns[i] > kArc * beside) corner_[i] = meeting_point(i);
    }
  }

  bool is_peak(const std::vector<double>& turns, std::size_t i) const {
    bool peak = true;
    for (const int direction : {-1, 1}) {
      loop_.along(i, direction, reach_, [&](std::size_t j, double) {
        peak = turns[j] < turns[i] || (turns[j] == turns[i] && j > i);
        return peak;
      });
      if (!peak) return false;
    }
    return true;
  }

  /// The point where the lines on both sides are nearest to each other.
  Vector3d meeting_point(std::size_t i) const {
    const Line before = *side(i, -1), behind = *side(i, 1);
    const double cosine = before.direction.dot(behind.direction);
    const Vector3d way = behind.point - before.point;
    const double square = 1 - cosine * cosine;
    const double s = (way.dot(before.direction) - cosine * way.dot(behind.direction)) / square;
    const double t = (cosine * way.dot(before.direction) - way.dot(behind.direction)) / square;
    return (before.point + s * before.direction + behind.point + t * behind.direction) / 2;
  }

  /// Value at the point of a quadratic fit over the length, up to the next corner on each side.
  Vector3d smooth(std::size_t i) const {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d right = Eigen::Matrix3d::Zero();
    std::size_t used = 0;
    const auto add = [&](const Vector3d& position, double at) {
      const Vector3d row(1, at, at * at);
      matrix += row * row.transpose();
      right += row * position.transpose();
      ++used;
    };
    add(loop_.position(i), 0);
    for (const int direction : {-1, 1}) {
      loop_.along(i, direction, reach_, [&](std::size_t j, double distance) {
        add(corner_[j] ? *corner_[j] : loop_.position(j), direction * distance / reach_);
        return !corner_[j];
      });
    }
    constexpr std::size_t kFewest = 4;  // points for three unknowns; chosen
    if (used < kFewest) return loop_.position(i);
    return right.transpose() * matrix.ldlt().solve(Vector3d::UnitX());
  }

  const Trace& border_;
  const Loop loop_;
  const double reach_;
  const double angle_;
  const MeshSearch& surface_;
  std::vector<std::optional<Vector3d>> corner_;  // [m]
};

}  // namespace

Trace smoothed_border(const Trace& border, double reach, double corner_angle,
                      const MeshSearch& surface) {
  return Smoothing(border, reach, corner_angle, surface).run();
}

}  // namespace part_recipes::path_design
