// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "text/blocks.h"
#include "tool_path_programs/source_text.h"

namespace tool_path_programs {

/// A program's text before it is split into files.
struct KrlRoutine {
  std::string name;
  std::vector<std::string> head;  //!< of the main file: comments, initialisation, frames
  std::vector<Block> blocks;      //!< in order
};

/// One file; if that is too long, a main file that calls name_1, name_2, ... in turn.
/// @throw scan_cell_common::InvalidParameter if a block or the main file does not fit max_lines
std::vector<SourceFile> krl_files(const KrlRoutine& routine, std::size_t max_lines);

}  // namespace tool_path_programs
