// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace part_recipes {

/// What the cell wrote about one work, or dry run, of a run's path.
struct WorkRecord {
  bool finished = false;   //!< to the end of the path
  std::size_t passed = 0;  //!< waypoints
};

/// All works, or all dry runs, of a run in which the robot passed a waypoint, oldest first:
/// ID.work.json, ID.work_2.json ... beside its folder.
/// @param run folder
/// @throw scan_cell_common::UnusableInput if a file is broken
std::vector<WorkRecord> work_records(const std::filesystem::path& run, bool dry);

}  // namespace part_recipes
