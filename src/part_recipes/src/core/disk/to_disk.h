// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace part_recipes {

/// Waits until a file, or the names in a folder, are on the disk.
/// @throw scan_cell_common::FileError if the disk did not take it
void to_disk(const std::filesystem::path& path);

/// @throw scan_cell_common::FileError with the same message and a cure
[[noreturn]] void throw_file_error(const std::filesystem::filesystem_error& error);

}  // namespace part_recipes
