// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "isolation/objects.h"

namespace cloud_preprocess {

/// Joins the pieces of an object that a shadow has torn apart. Between two objects that stand apart
/// the floor is seen; where it was not seen, a surface may lie that was not seen either. Two pieces
/// belong together if, over most of the border that faces the other one, the straight way across
/// (in plan view) shows no floor for a length of `gap` [m]. No shadow reaches further than 1.7
/// times the height of the higher piece above the floor.
/// @param cells that the objects' cells are indices into
/// @param floor with points
/// @return how many objects are fewer
std::size_t join_across_shadows(std::vector<Object>& objects, const Cloud& cells,
                                const SeenFloor& floor, double gap);

}  // namespace cloud_preprocess
