// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "recipe/recipe.h"

namespace part_recipes {

/// Reads every file of a recipe as its tools will.
/// @return what is missing or unusable, one line each with its cure; empty: nothing
std::vector<std::string> problems_of(const Recipe& recipe);

}  // namespace part_recipes
