// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/calls/tool_call.h"
#include "run/run_recipe.h"

namespace part_recipes {

/// Repeats a run from the contents of its folder: the same scan, recipe, settings and edits.
/// @param folder of the run
/// @param runs folder of the new run
/// @throw scan_cell_common::UnusableInput if the run is not as it was sealed, or has no scan
EndedRun run_again(const std::filesystem::path& folder, const std::filesystem::path& runs,
                   const StageBegins& begins, const Stop& stop = {});

/// The same, followed by edits of the adapted path by hand, after the run's own edits.
/// @param note of the person; empty: the run's own
/// @throw scan_cell_common::Refused if the run was not accepted
/// @throw as run_again()
EndedRun run_edited(const std::filesystem::path& folder,
                    const std::vector<tool_paths::PathEdit>& edits,
                    const std::filesystem::path& runs, const std::string& note,
                    const StageBegins& begins, const Stop& stop = {});

/// Runs the scan of a recorded run with another recipe, which need not be proven.
/// @throw as run_again()
EndedRun run_with(const std::filesystem::path& folder, const Recipe& recipe,
                  const std::filesystem::path& runs, const Stop& stop);

/// Names of the results that differ between two runs, byte for byte. Times and logs are left out.
/// @throw scan_cell_common::Error if one of the runs cannot be read
std::vector<std::string> differences(const std::filesystem::path& one,
                                     const std::filesystem::path& other);

}  // namespace part_recipes
