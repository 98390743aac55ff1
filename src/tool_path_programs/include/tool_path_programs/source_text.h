// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tool_path_programs {

/// A file of a program.
struct SourceFile {
  std::string name;  //!< without folder: part.src
  std::string text;  //!< contents
};

/// A place in a program's files.
struct Place {
  std::size_t file = 0;  //!< index of the file
  std::size_t line = 1;  //!< from 1
};

/// "part.src, line 12"
std::string to_string(const Place& place, const std::vector<SourceFile>& files);

/// Bytes of a file to replace.
struct TextEdit {
  std::size_t file = 0;    //!< index of the file
  std::size_t offset = 0;  //!< of the first byte
  std::size_t length = 0;  //!< in bytes; 0: insert
  std::string text;        //!< replacement
};

/// Applies all edits; every other byte stays. The order of the edits does not matter.
/// @throw std::logic_error if two edits overlap, or one is beyond its file
std::vector<SourceFile> edited(const std::vector<SourceFile>& files, std::vector<TextEdit> edits);

}  // namespace tool_path_programs
