// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "tool_path_programs/program.h"

namespace tool_path_programs {

/// Lines that a controller takes in one file, from public post processors: krc4 1400, krc2 2500.
/// @throw scan_cell_common::InvalidParameter if there is no such dialect
std::size_t krl_lines_of(const std::string& dialect);

/// Checks a routine's name, which is that of its file: letters, digits and _, at most 24.
/// @throw scan_cell_common::UnusableInput with a valid name
void check_krl_name(const std::string& name);

/// The number of a tool or base: "3", "TOOL_DATA[3]".
/// @param array TOOL_DATA or BASE_DATA
/// @throw scan_cell_common::UnusableInput if it is not a number from 0 to 128
int krl_frame_number(const std::string& name, const std::string& array);

/// @throw scan_cell_common::UnusableInput if it is not a number from 1 to 8192
int krl_output_number(const std::string& output);

}  // namespace tool_path_programs
