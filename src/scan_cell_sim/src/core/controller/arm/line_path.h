// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "controller/arm/flange_path.h"
#include "controller/arm/wire_pose.h"

namespace scan_cell_sim {

class LinePath : public FlangePath {
 public:
  /// @param euler A, E, R each change at their own rate; else the flange turns about one axis
  LinePath(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, bool euler);

  Eigen::Isometry3d flange(double way) const override;
  double length() const override { return (to_.translation() - from_.translation()).norm(); }

 private:
  std::string name() const override { return "line"; }
  std::vector<Stretch> stretches() const override;

  Eigen::Isometry3d from_;
  Eigen::Isometry3d to_;
  bool euler_;
  WireSix wire_from_;
  WireSix wire_to_;
};

}  // namespace scan_cell_sim
