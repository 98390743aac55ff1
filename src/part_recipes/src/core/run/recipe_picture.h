// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "recipe/recipe.h"

namespace part_recipes {

/// The picture in a recipe's folder.
constexpr const char* kPictureFile = "picture.png";

/// Draws the reference and the path on it.
/// @return what went wrong; empty: nothing. A recipe without a picture is valid
std::string draw_picture(const Recipe& recipe);

}  // namespace part_recipes
