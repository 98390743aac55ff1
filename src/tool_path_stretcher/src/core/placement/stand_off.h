// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "placement/track.h"

namespace tool_path_stretcher {

/// [m, reference] distance of each waypoint of a segment over the surface; 0 for all if the segment
/// has no stand-off.
std::vector<double> stand_offs(const Segment& segment, const Track& track,
                               const Surface& reference);

}  // namespace tool_path_stretcher
