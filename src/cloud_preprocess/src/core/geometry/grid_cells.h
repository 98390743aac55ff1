// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "scan_cell_common/clouds/cloud_files.h"

namespace cloud_preprocess {

/// The occupied cells of a grid through the origin, ordered by z, then y, then x.
struct GridCells {
  scan_cell_common::Cloud means;             //!< mean of each cell's points
  std::vector<std::uint32_t> cell_of_point;  //!< one per point: index of its cell
};

/// @param leaf [m] above 0
/// @throw scan_cell_common::UnusableInput if a point lies more than a million cells out
GridCells sort_into_grid(const scan_cell_common::Cloud& cloud, const Eigen::Vector3d& leaf);

/// The same, but neighbouring cells share the points of a face beside their border, as
/// scan_cell_common::with_even_cells() distributes them.
GridCells sort_into_even_grid(const scan_cell_common::Cloud& cloud, const Eigen::Vector3d& leaf);

}  // namespace cloud_preprocess
