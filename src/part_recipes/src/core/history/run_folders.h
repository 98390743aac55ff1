// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "history/history_rows.h"

namespace part_recipes {

/// Folders that hold a run, sorted by name: those with a run.json whose name does not begin with a
/// dot.
/// @param is_known folders of these names are left out, without reading them
/// @throw scan_cell_common::FileError if they cannot be listed
std::vector<std::filesystem::path> run_folders(
    const std::filesystem::path& runs, const std::function<bool(const std::string&)>& is_known);

/// A folder's run.json.
/// @throw scan_cell_common::FileError if there is none
/// @throw scan_cell_common::UnusableInput if it is broken, from a newer version, of another folder
/// or without a time in UTC
RunFile read_run_file(const std::filesystem::path& folder);

}  // namespace part_recipes
