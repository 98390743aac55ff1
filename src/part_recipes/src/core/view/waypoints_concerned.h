// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace part_recipes {

/// Numbers of the waypoints that the verdict of a run is about, counted over all segments, from its
/// report.json.
/// @return none if the run ended before there was a report
/// @throw scan_cell_common::UnusableInput if the report is broken
std::vector<std::uint32_t> waypoints_concerned(const std::filesystem::path& run);

}  // namespace part_recipes
