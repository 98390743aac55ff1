// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pass_planner/sight.h"
#include "scan_cell/scan_request.h"

namespace pass_planner {

/// The sightings, as the JSON text of docs/pass_planner.md: lengths in metres, angles in radians.
/// @param places, sight for the same waypoints
std::string sight_to_json(const std::vector<Surface::Place>& places, const PathSight& sight,
                          const std::vector<scan_cell::ScanPass>& passes);

/// For a person: how many waypoints are seen, and what hinders the others.
std::string summary_of(const PathSight& sight);

}  // namespace pass_planner
