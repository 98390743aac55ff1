// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "scan_cell_common/geometry/grid.h"

namespace scan_cell_common {

/// Redistributes the points of neighbouring cells that hold one piece of a surface among these
/// cells, in equal numbers and side by side along the piece; points in one place stay together.
/// Because of noise, a face near a border of cells has points on both sides. If the cells were
/// averaged as they are, the few points beyond the border would count as much as all others, and
/// shift the face by up to its noise.
///
/// Two neighbours are one piece if their means are less than half a cell apart across their border
/// and hardly along it, or if one has few points compared with the other and is less than a cell
/// away. This requires enough points to tell, and a border across which neither fills its cell.
/// @param entries from sort_into_grid() with this grid
/// @param position of a point by its index [m]
/// @return the same points in the same cells, in the order of sort_into_grid(); if the points of a
/// piece lie in fewer places than it has cells, some cells get none
std::vector<GridEntry> with_even_cells(std::vector<GridEntry> entries,
                                       const std::function<Eigen::Vector3d(std::size_t)>& position,
                                       const Grid& grid);

}  // namespace scan_cell_common
