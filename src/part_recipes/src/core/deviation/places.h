// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deviation/deviations.h"
#include "recipe/recipe.h"

namespace part_recipes {

/// The deviation at a named place.
struct PlaceDeviation {
  Place place;
  std::optional<double> deviation;  //!< [m] median of its points; none: too few
  std::size_t points = 0;           //!< of the object, with a deviation, within the radius
};

/// Reads a list of name, position [m on the reference] and radius [m], as save_places() writes it.
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
std::vector<Place> load_places(const std::string& file);

/// The median deviation of the points within each place's radius, if there are at least five of
/// them.
/// @param similarity reference to object; the radius is in the object's lengths
/// @param object [m]
/// @param deviations [m] one a point
std::vector<PlaceDeviation> at_places(const std::vector<Place>& places,
                                      const tool_path_stretcher::Similarity& similarity,
                                      const Points& object, const std::vector<double>& deviations);

}  // namespace part_recipes
