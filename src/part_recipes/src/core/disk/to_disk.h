// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace part_recipes {

/// Waits until a file, or the names in a folder, are on the disk.
/// @throw scan_cell_common::FileError where the disk did not take it
void to_disk(const std::filesystem::path& path);

}  // namespace part_recipes
