// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/recipe_picture.h"

#include "run/calls/tool_call.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {

std::string draw_picture(const Recipe& recipe) {
  const std::filesystem::path log = recipe.folder / "picture.log";
  std::string fault;
  try {
    const ToolCall call{"picture",
                        "part_recipes",
                        {"recipe_picture.py", "--reference", recipe.reference.file,
                         "--reference-units", recipe.reference.units, "--path", recipe.path.file,
                         "--path-units", recipe.path.units, "--output", kPictureFile}};
    if (run_tool(call, recipe.folder, log, {}).exit_code != 0) fault = last_line(log);
  } catch (const scan_cell_common::Error& error) {
    fault = error.what();
  }
  std::error_code failure;
  std::filesystem::remove(log, failure);
  return fault.empty() ? "" : "no picture: " + fault;
}

}  // namespace part_recipes
