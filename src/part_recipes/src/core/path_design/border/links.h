// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/border/border_distance.h"

namespace part_recipes::path_design {

/// Limits of a link between two rows of a raster.
struct LinkLimits {
  double longest = 0;  //!< [m] in a straight line
  double margin = 0;   //!< [m] from the borders, along the surface
  double aside = 0;    //!< [m] by which it may go round a border, or the margin
};

/// Joins rows to ways: from the end of each row to the nearest start in the next, as long as the
/// surface continues there; then from the first row that is left. Links follow the surface, and the
/// border where the straight line would leave the surface.
/// @param rows open lines, by plane; all in the same direction
std::vector<Trace> linked(const std::vector<std::vector<Trace>>& rows, const MeshSearch& surface,
                          const BorderDistance& border, const LinkLimits& limits);

}  // namespace part_recipes::path_design
