// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cloud_preprocess/object_isolation.h"
#include "geometry/grid_cells.h"
#include "geometry/kd_tree.h"

namespace cloud_preprocess {

/// A cluster of a grid's cells, and so of points.
struct Object {
  std::vector<KdTree::Index> cells;
  std::size_t points = 0;
};

/// The clusters with `min_points` or more.
/// @param gap [m]
/// @throw scan_cell_common::UnusableInput if there is none
std::vector<Object> find_objects(const GridCells& grid, double gap, int min_points);

/// Puts them in the order of the middles of their extents along the axis.
void sort_along(std::vector<Object>& objects, const Cloud& cells, Axis axis);

/// @param objects along the axis
/// @return index of the one that is asked for
/// @throw scan_cell_common::UnusableInput if there are not so many
std::size_t choose(const std::vector<Object>& objects, const Cloud& cells,
                   const IsolationParameters& parameters);

}  // namespace cloud_preprocess
