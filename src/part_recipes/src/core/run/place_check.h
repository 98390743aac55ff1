// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "recipe/recipe.h"
#include "run/run_recipe.h"

namespace part_recipes {

/// Result of a short scan of a part that was scanned before.
struct PlaceCheck {
  bool lies_there = false;        //!< as it did, within the recipe's tolerance
  std::optional<double> moved;    //!< [m] at most, of any place on the part; none: not found again
  std::optional<double> changed;  //!< [m] at most, of the path, beyond that
  std::string message;            //!< for a person
};

/// Scans the part of an accepted run with its recipe's check program, and adapts the run's path
/// from the first scan to this one. The result is kept beside the run's folder: ID.check.json.
/// @param recipe must have a check
/// @param run its folder
/// @param scan raw cloud [m] instead of the cell's; none: the running cell scans
/// @throw scan_cell_common::FileError if a tool cannot be called, or a file cannot be written
PlaceCheck check_place(const Recipe& recipe, const std::filesystem::path& run,
                       const RunRequest& request, const StageBegins& begins,
                       const std::optional<std::filesystem::path>& scan = std::nullopt);

}  // namespace part_recipes
