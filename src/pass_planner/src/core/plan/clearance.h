// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pass_planner/candidates.h"
#include "pass_planner/reach.h"

namespace pass_planner {

/// Checks that flange, camera and lasers keep clear of part and floor.
class Clearance {
 public:
  /// @param scanner, surface must outlive it
  /// @param reach gives the robot's start before the first pass, and the floor's frame
  Clearance(const scan_cell_common::ScannerModel& scanner, const Surface& surface,
            const Reach& reach, const PlanParameters& parameters);

  /// What comes too near during the last pass, or on the line to its start from the end of the pass
  /// before; empty: nothing.
  std::string refusal(const std::vector<scan_cell::ScanPass>& passes) const;

 private:
  const scan_cell_common::ScannerModel& scanner_;
  const Surface& surface_;
  const Eigen::Isometry3d start_;     // of the flange, before the first pass
  const Eigen::Isometry3d to_world_;  // from the passes' frame
  const double clearance_;            // [m]
  const double floor_height_;         // [m] in world
};

}  // namespace pass_planner
