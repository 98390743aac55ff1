// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace tool_path_programs {

constexpr std::size_t kLongestRapidName = 32;  // characters

/// @param thing that has the name, in the error
/// @param longest number of characters that are left for it
/// @throw scan_cell_common::UnusableInput naming a name that would do
void check_rapid_name(const std::string& thing, const std::string& name, std::size_t longest);

}  // namespace tool_path_programs
