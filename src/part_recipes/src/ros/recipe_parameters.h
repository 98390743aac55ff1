// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell_common/parameters/parameter_table.h"

namespace part_recipes {

/// Parameters of the node.
struct RecipeParameters {
  std::string recipes = "recipes";  //!< folder
  std::string runs = "runs";        //!< folder
  double timeout = 10;              //!< [s] to wait for the cell
};

inline void describe(scan_cell_common::ParameterTable& table, RecipeParameters& parameters) {
  table.add("recipes", parameters.recipes, "folder of the recipes");
  table.add("runs", parameters.runs, "folder of the runs; made if missing");
  table.add("timeout", parameters.timeout, {0.1, 3600, "s"}, "longest wait for the cell");
}

}  // namespace part_recipes
