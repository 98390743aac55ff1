// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_stretcher/similarity.h"

namespace scan_cell_common {
struct CloudView;
}

namespace tool_path_stretcher {

/// Unit vectors from the points to the viewers, at least 20 degrees apart. Directions with less
/// than 2 % of the points are left out.
/// @param points [m]; points that are not finite are ignored
/// @param viewers [m] one per point
Points directions_seen_from(const Points& points, const Points& viewers);

/// The same for a cloud whose points carry their viewpoint (vp_x, vp_y, vp_z); empty for others.
Points directions_seen_from(const scan_cell_common::CloudView& cloud);

}  // namespace tool_path_stretcher
