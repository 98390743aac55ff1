// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_programs/place_on_path.h"

#include <fmt/format.h>

#include <cmath>

namespace tool_path_programs {

std::string place_on_path(const PathWaypoints& waypoints, std::size_t pose, double way) {
  const auto at = [&](std::size_t i) { return i < waypoints.size() ? waypoints[i] : std::nullopt; };
  if (const auto waypoint = at(pose)) {
    if (way >= 1) return fmt::format("waypoint {}", *waypoint);
    return fmt::format("{} % of the way to waypoint {}", std::lround(100 * way), *waypoint);
  }
  if (pose > 0 && at(pose - 1)) return fmt::format("the retract from waypoint {}", *at(pose - 1));
  if (at(pose + 1)) return fmt::format("the approach to waypoint {}", *at(pose + 1));
  return fmt::format("pose {} of the tool", pose);
}

}  // namespace tool_path_programs
