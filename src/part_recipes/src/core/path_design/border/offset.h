// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/border/border_distance.h"

namespace part_recipes::path_design {

/// The lines at a distance from the borders of a surface: inwards, along the surface, or outwards,
/// straight on. Corners stay sharp where lines meet, and become arcs where they would part. If the
/// surface is too narrow, there are several lines instead of one, or none. Beside a ragged border a
/// line may stay open.
/// @param borders closed, the surface on their left
/// @param distance [m] inwards; below 0: outwards
/// @param corner_angle [rad] of the corners that are marked
std::vector<Trace> offset_from(const MeshSearch& surface, const std::vector<Trace>& borders,
                               double distance, double corner_angle);

}  // namespace part_recipes::path_design
