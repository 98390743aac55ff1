// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_path_stretcher/surface.h"
#include "tool_path_stretcher/tool_path.h"

namespace tool_path_stretcher {

/// How a path lies to the reference's surface: to all of it, where the reference is a part of one.
struct PathDistances {
  std::vector<double> far;   //!< [m] of each waypoint from the surface
  std::vector<bool> in_air;  //!< of each waypoint, over all segments: it has no surface beside it
  double reach = 0;          //!< [m] that a path which touches may be off its surface
};

/// What of a path is in the air: approach and retract, ways over openings and past the rim. There a
/// waypoint is farther off than its segment is led over the surface by as much again, and by more
/// than the surface may be inferred: `max_hole_distance`, or two spacings where those are more. A
/// segment is led over the surface if nine of ten of its waypoints do not touch and their median is
/// `max_stand_off` or less.
PathDistances distances_of(const ToolPath& path, const Surface& reference,
                           const StretchParameters& parameters);

/// The path without what is in the air.
ToolPath on_surface(const ToolPath& path, const Surface& reference,
                    const StretchParameters& parameters);

}  // namespace tool_path_stretcher
