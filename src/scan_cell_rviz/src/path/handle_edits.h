// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tool_paths/path_edits.h"

namespace scan_cell_rviz {

/// The edits that take a waypoint from one pose to another, in the tool's frame, applied to a
/// range; empty if the poses are the same.
/// @param before, after [m]
/// @param can_turn false: a path without orientations, which is moved in its own frame
std::vector<tool_paths::PathEdit> edits_between(const Eigen::Isometry3d& before,
                                                const Eigen::Isometry3d& after, bool can_turn,
                                                const tool_paths::WaypointRange& waypoints);

}  // namespace scan_cell_rviz
