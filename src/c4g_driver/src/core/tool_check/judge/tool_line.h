// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "c4g_driver/robot_model.h"
#include "c4g_driver/tool_motion.h"

namespace c4g_driver {

/// The way between two waypoints: the tip along a line, the tool about one axis, both evenly.
/// `way` runs from 0 to 1.
class ToolLine {
 public:
  /// @param motion outlives it
  /// @param waypoint at its end, from 1
  ToolLine(const ToolMotion& motion, std::size_t waypoint);

  Eigen::Isometry3d tip(double way) const;
  double length() const { return move_.norm(); }  // [m] of the tip
  double angle() const { return turn_.norm(); }   // [rad]
  int steps() const;                              // in which it is looked at

  /// Velocity of a flange there: translation [m], then rotation [rad], by the way.
  Eigen::Matrix<double, 6, 1> flange_rate(const Eigen::Isometry3d& tip,
                                          const Eigen::Isometry3d& flange) const;

 private:
  const Eigen::Isometry3d* from_;
  const Eigen::Isometry3d* to_;
  Eigen::Vector3d move_;  // [m]
  Eigen::Vector3d turn_;  // [rad] about its axis, in base_link
};

}  // namespace c4g_driver
