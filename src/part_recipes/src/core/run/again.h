// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/calls/tool_call.h"
#include "run/run_recipe.h"

namespace part_recipes {

/// Does a run again from what its folder holds: the same scan, recipe, settings and edits.
/// @param folder of the run
/// @param runs folder of the new run
/// @throw scan_cell_common::UnusableInput if the run is not as it was sealed, or has no scan
EndedRun run_again(const std::filesystem::path& folder, const std::filesystem::path& runs,
                   const StageBegins& begins, const Stop& stop = {});

/// The same, and then edits of the adapted path by hand, after those that the run has.
/// @param note of the person; empty: the run's own
/// @throw scan_cell_common::Refused if the run was not accepted @throw as run_again()
EndedRun run_edited(const std::filesystem::path& folder,
                    const std::vector<tool_paths::PathEdit>& edits,
                    const std::filesystem::path& runs, const std::string& note,
                    const StageBegins& begins, const Stop& stop = {});

/// The scan of a recorded run with another recipe, which need not be proven.
/// @throw as run_again()
EndedRun run_with(const std::filesystem::path& folder, const Recipe& recipe,
                  const std::filesystem::path& runs, const Stop& stop);

/// Names of the results that two runs do not have alike, byte for byte. Times and logs are left
/// out.
/// @throw scan_cell_common::Error if one of them cannot be read
std::vector<std::string> differences(const std::filesystem::path& one,
                                     const std::filesystem::path& other);

}  // namespace part_recipes
