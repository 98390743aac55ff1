// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace scan_cell_rviz {

/// The README's command that makes the recipe of the demo's part, to paste into a shell.
/// @param recipes folder for the recipe, relative to this process; empty: the placeholder FOLDER
std::string first_recipe_command(const std::string& recipes);

}  // namespace scan_cell_rviz
