// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "recipe/recipe.h"
#include "scan_cell/scan_program.h"

namespace part_recipes {

/// Replaces the edits by hand in a recipe's cleaning settings; everything else stays as written.
/// The recipe counts as made anew, not proven.
/// @param edits list in YAML with the key `edits` (docs/cloud_preprocess.md); empty: none
/// @throw scan_cell_common::UnusableInput naming line and entry of what makes no sense
/// @throw scan_cell_common::Refused if the recipe's files were changed since it was made or proven
/// @throw scan_cell_common::FileError
void set_edits(const Recipe& recipe, const std::string& edits);

/// Replaces the settings of the stages in the same way. A map that equals the existing one stays as
/// written.
/// @param stages the maps `floor`, `outliers` and `isolate` in YAML (docs/cloud_preprocess.md),
/// each whole: values that are not given are the defaults; a missing map stays
/// @throw as set_edits()
void set_stages(const Recipe& recipe, const std::string& stages);

/// Replaces the recipe's scan program. The recipe counts as made anew, not proven.
/// @throw scan_cell_common::Refused if a pass makes no sense, the recipe has no program, or its
/// files were changed since it was made or proven
/// @throw scan_cell_common::FileError
void set_program(const Recipe& recipe, const scan_cell::ScanProgram& program);

/// A recipe's cleaning settings, in YAML; empty: it has none.
/// @throw scan_cell_common::FileError
std::string cleaning_of(const Recipe& recipe);

}  // namespace part_recipes
