// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// @throw scan_cell_common::UnusableInput naming the first waypoint that RAPID cannot express
/// @throw scan_cell_common::InvalidParameter if a setting is invalid
WrittenProgram write_rapid(const Program& program, const WriteSettings& settings);

}  // namespace tool_path_programs
