// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_path_stretcher/surface.h"
#include "tool_path_stretcher/tool_path.h"

namespace tool_path_stretcher {

/// The position of a path relative to the reference's surface; to the whole surface if the
/// reference is a part of one.
struct PathDistances {
  std::vector<double> far;   //!< [m] of each waypoint from the surface
  std::vector<bool> in_air;  //!< of each waypoint, over all segments: no surface beside it
  double reach = 0;          //!< [m] a touching path may be this far off its surface
};

/// Finds the waypoints in the air: approach, retract, bridges over openings, ends past the rim. A
/// segment is led over the surface at a distance d if nine of ten of its waypoints do not touch and
/// their median distance d is at most `max_stand_off` plus a spacing; otherwise d is 0. A waypoint
/// is in the air if it is farther off than d by more than d again and by more than the surface may
/// be inferred: `max_hole_distance`, or two spacings if those are more.
PathDistances distances_of(const ToolPath& path, const Surface& reference,
                           const StretchParameters& parameters);

/// The path without the waypoints in the air.
ToolPath on_surface(const ToolPath& path, const Surface& reference,
                    const StretchParameters& parameters);

}  // namespace tool_path_stretcher
