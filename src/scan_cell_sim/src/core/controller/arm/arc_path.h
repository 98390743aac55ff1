// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "controller/arm/flange_path.h"

namespace scan_cell_sim {

/// A path along the circle through three positions, turning from each orientation to the next about
/// one axis; c4g_protocol.md. Written independently of the driver's arc, so that an error in either
/// shows.
class ArcPath : public FlangePath {
 public:
  /// @throw ControllerRefusal if the circle, or the turn, is not unique
  ArcPath(const Eigen::Isometry3d& from, const Eigen::Isometry3d& via, const Eigen::Isometry3d& to);

  Eigen::Isometry3d flange(double way) const override;
  double length() const override { return radius_ * sweep_; }

 private:
  std::string name() const override { return "arc"; }
  std::vector<Stretch> stretches() const override;

  /// [rad] from the start to a position on the circle, in the direction of motion
  double angle_to(const Eigen::Vector3d& place) const;

  Eigen::Vector3d centre_;
  Eigen::Vector3d outward_;  // from the centre to the start; unit
  Eigen::Vector3d forward_;  // of the motion at the start; unit
  double radius_;            // [m]
  double sweep_;             // [rad]
  double via_;               // way
  Eigen::Matrix3d from_;
  Eigen::Matrix3d at_via_;
  Eigen::AngleAxisd first_turn_;   // in the flange, up to via
  Eigen::AngleAxisd second_turn_;  // from there on
};

}  // namespace scan_cell_sim
