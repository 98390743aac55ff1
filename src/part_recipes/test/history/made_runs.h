// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "record/run_record.h"
#include "temporary_folder.h"

namespace part_recipes {

/// An accepted run whose figures encode its number: rms number * 1 um, places "left", "right" and
/// "rim" at number * 1 um, - number * 1 um and none. Runs start one second apart.
RunRecord made_run(std::uint64_t number, const std::string& recipe = "photo frame");

/// UTC, this many seconds after the start of 2026.
std::string time_after(std::uint64_t seconds);

/// Writes the folder of a run as a run does: under a dotted name until it is whole.
/// @return the folder
std::filesystem::path write_run(const std::filesystem::path& runs, const RunRecord& record);

}  // namespace part_recipes
