// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deviation/scene/path_reading.h"
#include "recipe/recipe.h"
#include "tool_path_stretcher/stretch_parameters.h"

namespace part_recipes {

/// How the tools of a run read the recipe's path, from the same options.
/// @throw scan_cell_common::UnusableInput if an option is unknown
PathReading reading_of(const RecipeFile& path);

/// The parameters by which stretch judges a part of the recipe: the recipe's, read as stretch reads
/// its command line, else the defaults.
/// @throw scan_cell_common::UnusableInput if they do not form a command line
/// @throw scan_cell_common::InvalidParameter if one is of the wrong kind, or out of its range
tool_path_stretcher::StretchParameters stretch_parameters_of(const Recipe& recipe);

}  // namespace part_recipes
