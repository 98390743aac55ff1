// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/calls/recipe_reading.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "run/calls/tool_call.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_options.h"

namespace part_recipes {
namespace {

/// Parses options as the tool that gets them does.
/// @param whose owner of the options, for the error; `cure` likewise
void parse(CLI::App& app, const ToolOptions& options, const std::string& whose,
           const std::string& cure) {
  ToolCall call;
  add_options(call, options);
  std::reverse(call.command.begin(), call.command.end());  // as CLI11 takes them
  try {
    app.parse(call.command);
  } catch (const CLI::ParseError& error) {
    throw scan_cell_common::UnusableInput(whose, error.what(), cure);
  }
}

}  // namespace

PathReading reading_of(const RecipeFile& path) {
  CLI::App app;
  PathReadingOptions options;
  options.units = path.units;
  add_reading_options(app, options);
  parse(app, path.options, path.file, "look at the options of the path in recipe.yaml");
  return options.typed();
}

tool_path_stretcher::StretchParameters stretch_parameters_of(const Recipe& recipe) {
  CLI::App app;
  app.allow_extras();  // options about the files
  tool_path_stretcher::StretchParameters parameters;
  scan_cell_common::ParameterOptions options;
  options.add(app, parameters);
  parse(app, recipe.stretch, "stretch", "look at the options of stretch in recipe.yaml");
  options.read(parameters);
  return parameters;
}

}  // namespace part_recipes
