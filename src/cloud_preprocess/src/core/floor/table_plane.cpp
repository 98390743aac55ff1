// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "floor/floor_plane.h"
#include "floor/sample_shares.h"

namespace cloud_preprocess {
namespace {

/// Points in the coordinates of a plane [m].
Eigen::Matrix2Xd flattened(const OrientedPoints& sample, const std::vector<Eigen::Index>& indices,
                           const Plane& plane) {
  const Eigen::Vector3d along = plane.normal.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> axes;
  axes.row(0) = along;
  axes.row(1) = plane.normal.cross(along);
  return axes * (sample.points(Eigen::all, indices).colwise() - plane.point);
}

/// The area covered by a plane's points: a convex outline, without the outermost few, and the grid
/// cells in it.
class Footprint {
 public:
  /// @param spacing [m] between neighbouring points
  Footprint(const Eigen::Matrix2Xd& points, double spacing) {
    constexpr double kOutermost = 0.005;  // of the points in each direction; chosen
    for (std::size_t i = 0; i < kDirections; ++i) {
      const double angle = 2 * M_PI * static_cast<double>(i) / kDirections;
      directions_[i] = {std::cos(angle), std::sin(angle)};
      const Eigen::RowVectorXd along = directions_[i].transpose() * points;
      std::vector<double> values(along.begin(), along.end());
      const auto outermost = values.begin() + static_cast<std::ptrdiff_t>(
                                                  kOutermost * static_cast<double>(values.size()));
      std::nth_element(values.begin(), outermost, values.end(), std::greater<>());
      reach_[i] = *outermost;
    }
    const double width = reach_[0] + reach_[kDirections / 2];
    const double depth = reach_[kDirections / 4] + reach_[3 * kDirections / 4];
    constexpr double kWithin = 0.02;  // of the width; chosen
    rim_ = kWithin * std::max(width, depth);
    constexpr double kSpacings = 6;   // about ten points per cell; chosen
    constexpr double kFinest = 1e-3;  // of the width; chosen
    side_ = std::max(kSpacings * spacing, kFinest * std::max(width, depth));
    for (const auto& point : points.colwise())
      cells_.insert(cell_of(point));
  }

  /// Whether a point is clearly inside the outline.
  bool surrounds(const Eigen::Vector2d& point) const {
    for (std::size_t i = 0; i < kDirections; ++i) {
      if (directions_[i].dot(point) > reach_[i] - rim_) return false;
    }
    return true;
  }

  /// Share of the plane's cells that also hold some of these points.
  double covered_by(const Eigen::Matrix2Xd& points) const {
    std::set<Cell> covered;
    for (const auto& point : points.colwise()) {
      const Cell cell = cell_of(point);
      if (cells_.count(cell) > 0) covered.insert(cell);
    }
    return static_cast<double>(covered.size()) / static_cast<double>(cells_.size());
  }

 private:
  static constexpr std::size_t kDirections = 16;  // chosen
  using Cell = std::pair<std::int64_t, std::int64_t>;

  Cell cell_of(const Eigen::Vector2d& point) const {
    return {std::llround(point.x() / side_), std::llround(point.y() / side_)};
  }

  std::array<Eigen::Vector2d, kDirections> directions_;
  std::array<double, kDirections> reach_{};
  double rim_ = 0;
  double side_ = 0;
  std::set<Cell> cells_;
};

/// The points on either side of a plane.
struct Sides {
  std::vector<Eigen::Index> above;  // by more than the margin
  std::size_t below = 0;
};

Sides sides_of(const Plane& plane, const OrientedPoints& sample,
               const FloorParameters& parameters) {
  Sides sides;
  for (Eigen::Index i = 0; i < sample.points.cols(); ++i) {
    const double height = plane.height(Eigen::Vector3d(sample.points.col(i)));
    if (height > std::max(parameters.margin, parameters.distance)) sides.above.push_back(i);
    if (height < -parameters.distance) ++sides.below;
  }
  return sides;
}

bool looks_like_table(const FoundPlane& found, const OrientedPoints& sample,
                      const FloorParameters& parameters) {
  constexpr double kMinOnIt = 0.005;    // of the sample; chosen, like the next
  constexpr double kSurrounded = 0.75;  // of what is in front: a rim's plane surrounds less
  constexpr double kMaxCovered = 0.5;   // of the plane: the far side of a plate covers it
  const Sides sides = sides_of(found.plane, sample, parameters);
  if (sides.below > share_of(sample, parameters.max_below)) return false;
  if (sides.above.size() <= share_of(sample, kMinOnIt)) return false;
  const Footprint footprint(flattened(sample, found.inliers, found.plane), sample.spacing);
  const Eigen::Matrix2Xd above = flattened(sample, sides.above, found.plane);
  std::size_t surrounded = 0;
  for (const auto& point : above.colwise())
    surrounded += footprint.surrounds(point) ? 1 : 0;
  return static_cast<double>(surrounded) >= kSurrounded * static_cast<double>(above.cols()) &&
         footprint.covered_by(above) <= kMaxCovered;
}

std::vector<Eigen::Index> all_but(const std::vector<Eigen::Index>& indices,
                                  const std::vector<Eigen::Index>& places) {
  std::vector<Eigen::Index> left;
  std::size_t next = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (next < places.size() && places[next] == static_cast<Eigen::Index>(i)) {
      ++next;
    } else {
      left.push_back(indices[i]);
    }
  }
  return left;
}

}  // namespace

std::optional<Floor> find_table(const OrientedPoints& sample, const FloorParameters& parameters) {
  constexpr int kMaxPlanes = 8;  // chosen
  const PlaneSearch search{parameters.distance, parameters.up.normalized(), M_PI};
  std::vector<Eigen::Index> left;
  for (Eigen::Index i = 0; i < sample.points.cols(); ++i)
    left.push_back(i);
  for (int planes = 0; planes < kMaxPlanes; ++planes) {
    const auto in_left = largest_plane(sample.only(left), search);
    if (!in_left || in_left->inliers.size() < min_points_of(sample, parameters)) break;
    FoundPlane found{in_left->plane, {}};
    for (const Eigen::Index place : in_left->inliers)
      found.inliers.push_back(left[static_cast<std::size_t>(place)]);
    for (int side = 0; side < 2; ++side) {
      if (looks_like_table(found, sample, parameters))
        return Floor{found.plane, found.inliers.size()};
      found.plane.normal = -found.plane.normal;
    }
    left = all_but(left, in_left->inliers);
  }
  return std::nullopt;
}

}  // namespace cloud_preprocess
