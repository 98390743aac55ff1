// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "scan_cell_common/geometry/grid.h"

namespace scan_cell_common {

/// Deals the points of neighbouring cells that hold one piece of a surface out among them anew, in
/// equal numbers and side by side along the piece; those in one place stay together. A face near a
/// border of cells has points on both sides, by its noise. With means of the cells as they are, the
/// few points beyond the border would count for as much as all others, and shift the face by up to
/// its noise.
///
/// Two neighbours are one piece if their means are less than half a cell apart across their border
/// and hardly along it, or if one has few points beside the other and is less than a cell apart;
/// but only with enough points to tell, and across a border along which neither fills its cell.
/// @param entries as sort_into_grid() gives them, with this grid
/// @param position of a point by its index [m]
/// @return the same points in the same cells, ordered as sort_into_grid() does; of cells whose
/// points lie in fewer places than there are cells some get none
std::vector<GridEntry> with_even_cells(std::vector<GridEntry> entries,
                                       const std::function<Eigen::Vector3d(std::size_t)>& position,
                                       const Grid& grid);

}  // namespace scan_cell_common
