// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tool_path_programs {

/// For each pose of the tool, its waypoint of the path, counted over all segments; none: approach
/// or retract.
using PathWaypoints = std::vector<std::optional<std::size_t>>;

/// Describes a pose of the tool by its place on the path: "waypoint 12", "35 % of the way to
/// waypoint 12", "the approach to waypoint 0", "the retract from waypoint 20".
/// @param pose index in `waypoints`
/// @param way 0 to 1: share of the way from the pose before; 1: at the pose
std::string place_on_path(const PathWaypoints& waypoints, std::size_t pose, double way);

}  // namespace tool_path_programs
