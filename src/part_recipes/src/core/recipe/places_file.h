// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "recipe/recipe.h"

namespace part_recipes {

/// File in which a run keeps the places for its tools.
constexpr const char* kPlacesFile = "places.yaml";

/// Writes a list of name, position [m] and radius [m].
/// @throw scan_cell_common::FileError if it cannot be written
void save_places(const std::string& file, const std::vector<Place>& places);

/// The same list within other YAML.
void write(YAML::Emitter& text, const std::vector<Place>& places);

}  // namespace part_recipes
