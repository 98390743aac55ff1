// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace c4g_driver {

/// The way of the flange in a MOVE_CARTESIAN along a line, without when. Positions lie on the
/// straight line; the orientation turns about one fixed axis, or A, E and R go each at its own
/// constant rate (the controller's parameter `interpolation`).
class Line {
 public:
  Line(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, bool euler);

  /// @param way from 0 to 1
  Eigen::Isometry3d at(double way) const;

  double length() const;  //!< [m]
  /// [rad] what is turned by; of A, E and R the most
  double angle() const;

 private:
  Eigen::Isometry3d from_;
  Eigen::Isometry3d to_;
  bool euler_;
  Eigen::Vector3d angles_;  // A, E, R [rad] of from_
  Eigen::Vector3d change_;  // of A, E, R
};

}  // namespace c4g_driver
