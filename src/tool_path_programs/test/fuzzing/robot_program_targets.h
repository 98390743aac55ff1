// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell_common/testing/fuzzing.h"
#include "tool_path_programs/language.h"

/// The readers of robot programs as fuzz targets, one per language.
std::vector<scan_cell_common::FuzzTarget> robot_program_targets();

/// Checks that a program that was read has finite poses, that it keeps every byte with the same
/// poses, and that it reads back with other poses.
/// @param bytes of the main file
void check_robot_program(const tool_path_programs::Language& language, const std::string& bytes,
                         const tool_path_programs::ReadSettings& settings = {});

scan_cell_common::FuzzTarget fanuc_target();
scan_cell_common::FuzzTarget gcode_target();
scan_cell_common::FuzzTarget krl_target();
scan_cell_common::FuzzTarget pdl2_target();
scan_cell_common::FuzzTarget rapid_target();
scan_cell_common::FuzzTarget urscript_target();
