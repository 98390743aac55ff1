// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/paths/path.h"

namespace c4g_driver {

/// A MOVE_CARTESIAN along a line: the orientation turns about one fixed axis, or A, E and R each
/// change at their own constant rate (the controller's parameter `interpolation`).
class Line : public Path {
 public:
  Line(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, bool euler);

  const char* name() const override { return "line"; }
  Eigen::Isometry3d at(double way) const override;
  std::vector<Stretch> stretches() const override;

 private:
  Eigen::Isometry3d from_;
  Eigen::Isometry3d to_;
  bool euler_;
  Eigen::Vector3d angles_;  // A, E, R [rad] of from_
  Eigen::Vector3d change_;  // of A, E, R
};

}  // namespace c4g_driver
