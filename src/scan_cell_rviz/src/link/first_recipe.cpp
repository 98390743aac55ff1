// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/first_recipe.h"

#include <filesystem>

namespace scan_cell_rviz {
namespace {

/// From the README.
constexpr const char* kCommand =
    "rosrun part_recipes recipe new frame --reference out/reference.ply --path out/tool_path.csv "
    "--program $(rospack find scan_cell)/config/both_lasers.yaml --work waypoint_z=into_part "
    "--robot-program frame.src --program-option waypoint_z=into_part";

/// Quotes any text as one word of a shell.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char letter : word)
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

}  // namespace

std::string first_recipe_command(const std::string& recipes) {
  const std::string folder =
      recipes.empty() ? "FOLDER" : quoted(std::filesystem::absolute(recipes).string());
  return std::string(kCommand) + " --recipes " + folder;
}

}  // namespace scan_cell_rviz
