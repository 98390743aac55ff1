// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

class GcodeDialect;

/// Makes sure that G-code can say a program.
/// @throw scan_cell_common::UnusableInput naming the first waypoint that it cannot say, and the
/// cure
void check_for_gcode(const Program& program, const WriteSettings& settings,
                     const GcodeDialect& dialect);

/// Digits behind the point of feeds [mm/min] and of tolerances [mm].
constexpr int kGcodeFeedDigits = 3;
constexpr int kGcodeToleranceDigits = 4;

}  // namespace tool_path_programs
