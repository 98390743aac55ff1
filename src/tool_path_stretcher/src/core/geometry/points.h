// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

/// The mean of the points in each cell of a grid (thesis 8.5), in the order of the cells.
/// Neighbouring cells share the points of a face beside their border, as
/// scan_cell_common::with_even_cells() distributes them.
/// @param leaf edges of a cell [m], above 0
/// @throw scan_cell_common::InvalidParameter if a leaf is not above 0
/// @throw scan_cell_common::UnusableInput if a point is not finite, or too far out to number its
/// cell
Points reduce_on_grid(const Points& points, const Eigen::Vector3d& leaf);

/// Indices of at most `most` points, spread evenly over the space that the points fill: one per
/// cubic cell, whatever the density.
std::vector<std::size_t> spread_evenly(const Points& points, std::size_t most);

Points select(const Points& points, const std::vector<std::size_t>& indices);

Points turned(const Points& points, const Eigen::Matrix3d& rotation);

/// Centroid, principal axes (columns, right-handed, longest first) and the standard deviation along
/// each [m].
struct PrincipalFrame {
  Eigen::Vector3d centroid;
  Eigen::Matrix3d axes;
  Eigen::Vector3d deviation;
};
PrincipalFrame principal_frame(const Points& points);

}  // namespace tool_path_stretcher
