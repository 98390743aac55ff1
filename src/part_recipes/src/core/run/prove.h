// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run/run_recipe.h"

namespace part_recipes {

/// Runs a recipe on its reference part. The recipe is proven with its present files and calibration
/// if the path is accepted, and the root mean square of all deviations and the deviation of each
/// named place are within the tolerance.
/// @return the run that proved it
/// @throw scan_cell_common::Refused naming what is out of tolerance; the recipe stays as it was
EndedRun prove(const Recipe& recipe, RunRequest request, const StageBegins& begins = {});

}  // namespace part_recipes
