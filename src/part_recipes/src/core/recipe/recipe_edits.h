// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "recipe/recipe.h"
#include "scan_cell/scan_program.h"

namespace part_recipes {

/// Puts edits by hand into a recipe's cleaning settings, in place of those that are there; all else
/// stays as it is written. The recipe counts as made anew, not proven.
/// @param edits list in YAML with the key `edits` (docs/cloud_preprocess.md); empty: none
/// @throw scan_cell_common::UnusableInput naming line and entry of what makes no sense
/// @throw scan_cell_common::Refused if the recipe's files were changed since it was made or proven
/// @throw scan_cell_common::FileError
void set_edits(const Recipe& recipe, const std::string& edits);

/// Likewise the settings of the stages. A map that says what is there already stays as it is
/// written.
/// @param stages the maps `floor`, `outliers` and `isolate` in YAML (docs/cloud_preprocess.md),
/// each whole: what is not given is as by default; a map that is missing stays
/// @throw as set_edits()
void set_stages(const Recipe& recipe, const std::string& stages);

/// Puts a scan program in place of the recipe's. The recipe counts as made anew, not proven.
/// @throw scan_cell_common::Refused if a pass makes no sense, the recipe has no program, or its
/// files were changed since it was made or proven
/// @throw scan_cell_common::FileError
void set_program(const Recipe& recipe, const scan_cell::ScanProgram& program);

/// A recipe's cleaning settings, in YAML; empty: it has none.
/// @throw scan_cell_common::FileError
std::string cleaning_of(const Recipe& recipe);

}  // namespace part_recipes
