// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_stretcher/similarity.h"

namespace scan_cell_common {
struct CloudView;
}

namespace tool_path_stretcher {

/// The directions from which points were seen, each 20 degrees or more from the others, unit
/// length, from the points to the viewers. Directions of less than 2 % of the points are left out.
/// @param points [m], not finite ones are left out
/// @param viewers [m] one a point
Points directions_seen_from(const Points& points, const Points& viewers);

/// The same of a cloud whose points carry their viewpoint (vp_x, vp_y, vp_z); empty of others.
Points directions_seen_from(const scan_cell_common::CloudView& cloud);

}  // namespace tool_path_stretcher
