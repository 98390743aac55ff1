// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/recipe_reading.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "run/calls/tool_call.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {

PathReading reading_of(const RecipeFile& path) {
  CLI::App app;
  PathReadingOptions options;
  options.units = path.units;
  add_reading_options(app, options);
  ToolCall call;
  add_options(call, path.options);
  std::reverse(call.command.begin(), call.command.end());  // as CLI11 takes them
  try {
    app.parse(call.command);
  } catch (const CLI::ParseError& error) {
    throw scan_cell_common::UnusableInput(path.file, error.what(),
                                          "look at the options of the path in recipe.yaml");
  }
  return options.typed();
}

}  // namespace part_recipes
