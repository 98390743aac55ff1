// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace tool_path_programs {

constexpr std::size_t kLongestRapidName = 32;  // characters

/// @param thing what has the name, for the error
/// @param longest characters left for the name
/// @throw scan_cell_common::UnusableInput naming a valid name
void check_rapid_name(const std::string& thing, const std::string& name, std::size_t longest);

}  // namespace tool_path_programs
