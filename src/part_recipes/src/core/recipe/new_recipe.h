// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "recipe/proof.h"
#include "recipe/recipe.h"

namespace part_recipes {

/// What a recipe is made from. Its files are copied.
struct NewRecipe {
  std::string name;                    //!< of the recipe and of its folder
  std::string program;                 //!< scan program; empty: none
  std::string cleaning;                //!< settings of clean_cloud; empty: its defaults
  RecipeFile reference;                //!< clean cloud or mesh
  RecipeFile path;                     //!< proven on it
  double tolerance = 0.0005;           //!< [m]
  ToolOptions stretch;                 //!< parameters
  std::vector<Place> places;           //!< on the reference
  std::vector<RobotProgram> programs;  //!< to write
  ToolOptions work;                    //!< of work
  std::string check_program;           //!< scan program before the work; empty: none
  double check_tolerance = 0.0005;     //!< [m]
  Hashes calibration;                  //!< of the cell that scanned the reference; empty: not known
};

/// Makes RECIPES/NAME with its files, recipe.yaml and a proof that says it was made and not proven.
/// The recipe is made whole, or not at all.
/// @return the recipe
/// @throw scan_cell_common::InvalidParameter if the name is not allowed
/// @throw scan_cell_common::FileError if the recipe exists already, or a file cannot be copied
/// @throw scan_cell_common::UnusableInput if a file is unusable, as from problems_of()
Recipe make_recipe(const std::filesystem::path& recipes, const NewRecipe& made);

}  // namespace part_recipes
