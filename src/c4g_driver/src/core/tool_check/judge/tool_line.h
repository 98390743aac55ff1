// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "c4g_driver/robot_model.h"
#include "c4g_driver/tool_motion.h"

namespace c4g_driver {

/// The way between two waypoints: the tip moves along a line and the tool turns about one axis,
/// both evenly. `way` runs from 0 to 1.
class ToolLine {
 public:
  /// @param motion must outlive this object
  /// @param waypoint at its end, from 1
  ToolLine(const ToolMotion& motion, std::size_t waypoint);

  Eigen::Isometry3d tip(double way) const;
  double length() const { return move_.norm(); }  // [m] of the tip
  double angle() const { return turn_.norm(); }   // [rad]
  int steps() const;                              // number of steps in which it is checked

  /// Derivative of the flange's pose by the way: translation [m], then rotation [rad].
  Eigen::Matrix<double, 6, 1> flange_rate(const Eigen::Isometry3d& tip,
                                          const Eigen::Isometry3d& flange) const;

 private:
  const Eigen::Isometry3d* from_;
  const Eigen::Isometry3d* to_;
  Eigen::Vector3d move_;  // [m]
  Eigen::Vector3d turn_;  // [rad] about its axis, in base_link
};

}  // namespace c4g_driver
