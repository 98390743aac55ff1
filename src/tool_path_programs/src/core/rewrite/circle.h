// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace tool_path_programs {

/// A place on an arc.
struct ArcPlace {
  Eigen::Vector3d position;  //!< [m]
  double angle = 0;          //!< [rad] from the start, along the arc
};

/// The circle through three points [m], and the arc from the first through the second to the third.
class Circle {
 public:
  /// @return none if the points lie on a line, or two of them coincide
  static std::optional<Circle> through(const Eigen::Vector3d& from, const Eigen::Vector3d& via,
                                       const Eigen::Vector3d& to);

  /// [m] to the nearest point of the whole circle.
  double distance(const Eigen::Vector3d& point) const;

  /// Places on the arc, in order, at most `step` [m] apart, without its ends and its via.
  std::vector<ArcPlace> places(double step) const;

  double radius() const { return radius_.norm(); }  //!< [m]
  double via_angle() const { return via_; }         //!< [rad] from the start, along the arc
  double sweep() const { return sweep_; }           //!< [rad] to the end

 private:
  Circle() = default;
  double angle_to(const Eigen::Vector3d& point) const;

  Eigen::Vector3d centre_;
  Eigen::Vector3d radius_;  // from the centre to the start
  Eigen::Vector3d axis_;    // of the arc's turn
  double via_ = 0;          // [rad] along the arc
  double sweep_ = 0;        // [rad]
};

}  // namespace tool_path_programs
