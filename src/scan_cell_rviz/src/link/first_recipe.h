// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace scan_cell_rviz {

/// The README's command for the recipe of the demo's part, to be pasted into a shell.
/// @param recipes folder that the recipe goes into; relative ones are of this process; empty: to be
/// filled in, FOLDER
std::string first_recipe_command(const std::string& recipes);

}  // namespace scan_cell_rviz
