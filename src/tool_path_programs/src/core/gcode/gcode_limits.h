// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

class GcodeDialect;

/// Checks that G-code can express a program.
/// @throw scan_cell_common::UnusableInput naming the first waypoint that it cannot express, and the
/// cure
void check_for_gcode(const Program& program, const WriteSettings& settings,
                     const GcodeDialect& dialect);

/// Decimals of feeds [mm/min] and tolerances [mm].
constexpr int kGcodeFeedDigits = 3;
constexpr int kGcodeToleranceDigits = 4;

}  // namespace tool_path_programs
