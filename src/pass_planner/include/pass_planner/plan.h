// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pass_planner/candidates.h"
#include "pass_planner/reach.h"

namespace pass_planner {

/// Passes that see waypoints, and what they do not see.
struct PassPlan {
  std::vector<scan_cell::ScanPass> passes;  //!< in the order of choice
  std::vector<std::size_t> left;            //!< indices of the places that none of them sees
  std::vector<std::string> why;             //!< for a person, one for each of `left`
};

/// Chooses passes that see the places, within the robot's reach and clear of the part. Each pass is
/// the one that sees most of the places that are left and, among those, sees them at the best
/// angles (greedy set cover). All places are to be seen at good angles if possible, otherwise
/// within the limits of `sight`. The same input gives the same passes.
/// @param places on the part
/// @param first passes that are run before; the robot starts at the end of the last
/// @throw scan_cell_common::InvalidParameter if the parameters make no sense
/// @throw scan_cell_common::UnusableInput if the places are too far apart for passes, as when the
/// part is in another unit
PassPlan plan_passes(const scan_cell_common::ScannerModel& scanner, const Surface& surface,
                     const std::vector<Surface::Place>& places, const SightParameters& sight,
                     const Reach& reach, const PlanParameters& parameters,
                     const std::vector<scan_cell::ScanPass>& first = {});

}  // namespace pass_planner
