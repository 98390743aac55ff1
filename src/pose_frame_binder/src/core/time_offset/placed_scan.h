// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "scan_cell_common/geometry/kd_tree.h"
#include "time_offset/time_offset.h"

namespace pose_frame_binder {

/// The points of a scan, placed with the poses taken `delay` later than the pulses, and how they
/// move with the delay.
class PlacedScan {
 public:
  struct Point {
    Eigen::Vector3d place;
    Eigen::Vector3d velocity;  //!< d place / d delay [m/s]
  };

  /// The plane through a few points around a place.
  struct Patch {
    Eigen::Vector3d middle;
    Eigen::Vector3d normal;
    Eigen::Matrix3d normal_noise;  //!< covariance of the normal, from the patch's roughness
    Eigen::Vector3d velocity;
  };

  /// @param most most points kept; if there are more, an even selection
  PlacedScan(const UnboundScan& scan, double delay, std::size_t most,
             const TimeOffsetSettings& settings);
  PlacedScan(const PlacedScan&) = delete;  // the tree refers to the points
  PlacedScan& operator=(const PlacedScan&) = delete;

  const std::vector<Point>& points() const { return points_; }
  Eigen::Vector3d mean_velocity() const;

  /// None if nothing is near, or the points there are not a plane or lie on one side only.
  std::optional<Patch> patch_at(const Eigen::Vector3d& place) const;

  /// Distance to the nearest point [m].
  double distance(const Eigen::Vector3d& place) const;

 private:
  struct Coordinate {
    double operator()(const Point& point, std::size_t axis) const {
      return point.place[static_cast<Eigen::Index>(axis)];
    }
  };
  using Tree = scan_cell_common::KdTree<std::vector<Point>, Coordinate, double>;

  const double max_distance_;
  std::vector<Point> points_;
  std::optional<Tree> tree_;
};

}  // namespace pose_frame_binder
