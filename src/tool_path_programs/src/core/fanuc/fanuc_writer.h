// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// Whether the dialect of the settings writes zones as lengths.
/// @throw scan_cell_common::InvalidParameter if there is no such dialect
bool fanuc_has_corner_regions(const WriteSettings& settings);

/// @throw scan_cell_common::UnusableInput naming the first waypoint that FANUC TP cannot express
/// @throw scan_cell_common::InvalidParameter if a setting is invalid
WrittenProgram write_fanuc(const Program& program, const WriteSettings& settings);

}  // namespace tool_path_programs
