// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "text/blocks.h"
#include "tool_path_programs/source_text.h"

namespace tool_path_programs {

/// A program's text before it is split into files.
struct Pdl2Routine {
  std::string name;
  std::vector<std::string> comments;
  std::vector<std::string> variables;  //!< declarations of frames held by other programs
  std::vector<std::string> head;       //!< first statements of the main program
  std::vector<Block> blocks;           //!< in order
};

/// @throw scan_cell_common::UnusableInput with a valid name: letters, digits and _, at most 32
void check_pdl2_name(const std::string& thing, const std::string& name);

/// One program; if that is too long, a main program that calls the routines R_name_1, R_name_2, ...
/// of programs name_1, name_2, ...
/// @throw scan_cell_common::InvalidParameter if a block or the main program does not fit max_lines
std::vector<SourceFile> pdl2_files(const Pdl2Routine& routine, std::size_t max_lines);

}  // namespace tool_path_programs
