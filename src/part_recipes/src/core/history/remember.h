// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run/run_recipe.h"

namespace part_recipes {

/// Adds a run that just ended to the history beside it. If that fails, the run says so in its
/// warning: it is still a run, and `history rebuild` finds it.
void remember(EndedRun& run);

}  // namespace part_recipes
