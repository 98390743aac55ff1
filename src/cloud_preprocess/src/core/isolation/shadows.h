// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "isolation/objects.h"

namespace cloud_preprocess {

/// Joins the pieces of an object separated by a shadow. Between two separate objects the floor is
/// seen; where it was not seen, there may be a surface that was not seen either. Two pieces belong
/// together if, over most of the border that faces the other piece, the straight line across (in
/// plan view) shows no floor for a length of `gap` [m]. No shadow reaches farther than 1.7 times
/// the height of the higher piece above the floor.
/// @param cells to which the objects' cells are indices
/// @param floor must have points
/// @return by how many the objects became fewer
std::size_t join_across_shadows(std::vector<Object>& objects, const Cloud& cells,
                                const SeenFloor& floor, double gap);

}  // namespace cloud_preprocess
