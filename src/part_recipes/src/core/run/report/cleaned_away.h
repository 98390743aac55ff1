// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "recipe/recipe.h"
#include "tool_path_stretcher/similarity.h"

namespace part_recipes {

/// Finds the places that the cleaning left bare. Whether it took points of the part there, or of
/// something beneath it, is not known.
/// @param places [m] on the object's surface
/// @param raw cloud [m] before the cleaning; points that are not finite are left out
/// @param clean cloud [m] after the cleaning, at least 20 points
/// @param near [m] distance within which a point counts as at the place. It is increased to one
/// spacing of the raw cloud there, and to two of the clean one, which is thinner
/// @return indices of the places near which the raw cloud has a point and the clean one has none
/// @throw scan_cell_common::UnusableInput if the clean cloud is too small
std::vector<std::size_t> cleaned_away(const tool_path_stretcher::Points& places,
                                      const tool_path_stretcher::Points& raw,
                                      const tool_path_stretcher::Points& clean, double near);

/// A run whose adaptation was refused.
struct RefusedRun {
  std::filesystem::path inputs;  //!< folder with the recipe's files
  std::filesystem::path scan;    //!< raw cloud
  std::string scan_units;        //!< of that: m, mm or inch
  std::filesystem::path clean;   //!< clean cloud, in metres
  std::filesystem::path report;  //!< of stretch
};

/// Waypoints that the verdict is about and at which the raw scan has points that the clean cloud
/// lacks. Each is looked up on the reference beside it, moved by the part's pose. Points count
/// within the distance that a waypoint may have from the surface (`tolerance` of stretch).
/// @return numbers, counted over all segments; none if the report has no pose, or numbers other
/// waypoints than those of the path
/// @throw scan_cell_common::Error from the readers of the files
std::vector<std::size_t> waypoints_cleaned_away(const Recipe& recipe, const RefusedRun& run);

}  // namespace part_recipes
