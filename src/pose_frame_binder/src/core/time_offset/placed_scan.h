// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "scan_cell_common/geometry/kd_tree.h"
#include "time_offset/time_offset.h"

namespace pose_frame_binder {

/// The points of a scan with the poses taken so much later than the pulses, and how they move with
/// that delay.
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
    Eigen::Matrix3d normal_noise;  //!< covariance of the normal, from how rough the patch is
    Eigen::Vector3d velocity;
  };

  /// @param most points; of more than that, some are left out evenly
  PlacedScan(const UnboundScan& scan, double delay, std::size_t most,
             const TimeOffsetSettings& settings);
  PlacedScan(const PlacedScan&) = delete;  // the tree knows where it is
  PlacedScan& operator=(const PlacedScan&) = delete;

  const std::vector<Point>& points() const { return points_; }
  Eigen::Vector3d mean_velocity() const;

  /// Where nothing lies near, or what lies there is no plane or only on one side: none.
  std::optional<Patch> patch_at(const Eigen::Vector3d& place) const;

  /// To the nearest point [m].
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
