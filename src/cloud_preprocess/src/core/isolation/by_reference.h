// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "isolation/objects.h"

namespace cloud_preprocess {

/// The points of one object among several.
struct ChosenPoints {
  std::vector<bool> kept;  //!< of each point of the cloud
  std::size_t beside = 0;  //!< number kept that are not explained, but over the part or near it
};

/// The points that the reference explains, and those over it (along the floor's normal, if a floor
/// was seen) or nearer to it than the gap, which may be in a path's way.
/// @param objects clusters of the grid's cells
/// @param parameters with a finder
/// @throw scan_cell_common::UnusableInput if the reference explains nothing, or several things
ChosenPoints choose_by_reference(const TracedCloud& cloud, const GridCells& grid,
                                 const std::vector<Object>& objects,
                                 const IsolationParameters& parameters);

}  // namespace cloud_preprocess
