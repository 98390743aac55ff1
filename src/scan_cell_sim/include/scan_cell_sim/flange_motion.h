// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "scan_cell_common/pose/timed_pose.h"

namespace scan_cell_sim {

/// True pose of the flange, now and in the past. Safe to call from any thread.
class FlangeMotion {
 public:
  virtual ~FlangeMotion() = default;

  /// True pose of tool0 in base_link at an instant of the host's clock.
  virtual Eigen::Isometry3d flange_at(scan_cell_common::Nanoseconds host) const = 0;
};

}  // namespace scan_cell_sim
