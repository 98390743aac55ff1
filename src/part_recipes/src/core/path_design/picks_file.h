// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "path_design/surface/part_mesh.h"

namespace part_recipes {

/// Picked points [m] from a text file of x, y and z, with or without a header that names them.
/// @param metres_per_unit of the file
/// @throw scan_cell_common::FileError if it is missing, unreadable or no such table
path_design::Points load_picks(const std::string& file, double metres_per_unit);

}  // namespace part_recipes
