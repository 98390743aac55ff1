// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/stretch_given.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "run/calls/tool_call.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_options.h"

namespace part_recipes {

tool_path_stretcher::StretchParameters stretch_parameters_of(const Recipe& recipe) {
  CLI::App app;
  app.allow_extras();  // what is said of the files
  tool_path_stretcher::StretchParameters parameters;
  scan_cell_common::ParameterOptions options;
  options.add(app, parameters);
  ToolCall call;
  add_options(call, recipe.stretch);
  std::reverse(call.command.begin(), call.command.end());  // as CLI11 takes them
  try {
    app.parse(call.command);
  } catch (const CLI::ParseError& error) {
    throw scan_cell_common::UnusableInput("stretch", error.what(),
                                          "look at the options of stretch in recipe.yaml");
  }
  options.read(parameters);
  return parameters;
}

}  // namespace part_recipes
