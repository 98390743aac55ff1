// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// A letter with its number
struct GcodeWord {
  char letter = 'G';  //!< upper case
  double value = 0;
  std::size_t offset = 0;         //!< of the letter, in the file
  std::size_t number_offset = 0;  //!< of the number
  std::size_t number_length = 0;
};

/// A line of a program.
struct GcodeBlock {
  std::vector<GcodeWord> words;  //!< without line numbers
  std::size_t line = 1;          //!< from 1
  bool may_be_skipped = false;   //!< begins with /

  /// The last word with that letter; null: none.
  const GcodeWord* find(char letter) const;
};

/// The bytes from a block's first word to its last.
ByteRange gcode_range(const GcodeBlock& block);

/// The lines of a program that hold words. Comments in brackets and after ; are left out, and so
/// are lines with %, program numbers and lines that set parameters.
/// @throw scan_cell_common::UnusableInput naming file and line of anything else, such as a computed
/// number or a subroutine
std::vector<GcodeBlock> gcode_blocks(const SourceFile& file);

}  // namespace tool_path_programs
