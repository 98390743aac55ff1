// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cloud_preprocess/object_isolation.h"
#include "geometry/grid_cells.h"
#include "geometry/kd_tree.h"

namespace cloud_preprocess {

/// A cluster of a grid's cells, and thus of points.
struct Object {
  std::vector<KdTree::Index> cells;
  std::size_t points = 0;
};

/// The clusters with at least `min_points` points.
/// @param gap [m]
/// @throw scan_cell_common::UnusableInput if there is none
std::vector<Object> find_objects(const GridCells& grid, double gap, int min_points);

/// Sorts the objects by the middle of their extent along the axis.
void sort_along(std::vector<Object>& objects, const Cloud& cells, Axis axis);

/// @param objects along the axis
/// @return index of the requested object
/// @throw scan_cell_common::UnusableInput if there are too few objects
std::size_t choose(const std::vector<Object>& objects, const Cloud& cells,
                   const IsolationParameters& parameters);

}  // namespace cloud_preprocess
