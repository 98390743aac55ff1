// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deviation/scene/path_reading.h"
#include "recipe/recipe.h"

namespace part_recipes {

/// How the tools of a run read the recipe's path, from the same options.
/// @throw scan_cell_common::UnusableInput if an option is none
PathReading reading_of(const RecipeFile& path);

}  // namespace part_recipes
