// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pass_planner/candidates.h"

namespace pass_planner {

/// Whether flange, camera and lasers keep clear of part and floor.
class Clearance {
 public:
  /// @param scanner, surface must outlive it
  Clearance(const scan_cell_common::ScannerModel& scanner, const Surface& surface,
            const PlanParameters& parameters);

  /// What comes too near in the last of the passes, or on the line from the pass before to its
  /// start; empty: nothing.
  std::string refusal(const std::vector<scan_cell::ScanPass>& passes) const;

 private:
  const scan_cell_common::ScannerModel& scanner_;
  const Surface& surface_;
  const double clearance_;     // [m]
  const double floor_height_;  // [m]
};

}  // namespace pass_planner
