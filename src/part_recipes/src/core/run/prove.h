// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run/run_recipe.h"

namespace part_recipes {

/// Runs a recipe on its reference part. Where the path is accepted, and the root mean square of all
/// deviations and the deviation of each named place are within the tolerance, the recipe is proven
/// with its files and calibration as they are now.
/// @return the run that proved it
/// @throw scan_cell_common::Refused naming what is out of tolerance; the recipe stays as it was
EndedRun prove(const Recipe& recipe, RunRequest request, const StageBegins& begins = {});

}  // namespace part_recipes
