// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "recipe/recipe.h"

namespace part_recipes {

/// Puts edits by hand into a recipe's cleaning settings, in place of those that are there; all else
/// stays as it is written. The recipe counts as made anew, not proven.
/// @param edits list in YAML with the key `edits` (docs/cloud_preprocess.md); empty: none
/// @throw scan_cell_common::UnusableInput naming line and entry of what makes no sense
/// @throw scan_cell_common::Refused if the recipe's files were changed since it was made or proven
/// @throw scan_cell_common::FileError
void set_edits(const Recipe& recipe, const std::string& edits);

}  // namespace part_recipes
