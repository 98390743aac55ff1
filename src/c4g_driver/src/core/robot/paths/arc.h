// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/paths/path.h"

namespace c4g_driver {

/// A MOVE_CIRCULAR: along the circle through three positions. The orientation turns about one axis
/// to that of `via`, reached at `via`, and about another axis to that of `to`.
class Arc : public Path {
 public:
  /// @throw scan_cell_common::Refused if no circle passes through the positions, or two
  /// orientations are half a turn apart; limits in c4g_protocol.md
  Arc(const Eigen::Isometry3d& from, const Eigen::Isometry3d& via, const Eigen::Isometry3d& to);

  const char* name() const override { return "arc"; }
  Eigen::Isometry3d at(double way) const override;
  std::vector<Stretch> stretches() const override;

 private:
  double angle_to(const Eigen::Isometry3d& pose) const;

  Eigen::Isometry3d from_;
  Eigen::Isometry3d via_;
  Eigen::Isometry3d to_;
  Eigen::Vector3d radius_;  // [m] from the centre to the start
  Eigen::Vector3d axis_;    // of the motion
  double sweep_;            // [rad]
  double way_of_via_;
};

}  // namespace c4g_driver
