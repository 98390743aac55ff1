// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// The statement of an arc, some of whose pieces are changed.
class ArcStatement {
 public:
  ArcStatement(const ProgramText& text, std::size_t step);

  const ArcText& pieces() const { return arc_; }
  std::string piece(const ByteRange& range) const;  //!< as in the file

  ArcStatement& put(const ByteRange& range, const std::string& text);
  std::string text() const;  //!< of the changed statement

 private:
  const std::string& file_;
  const ArcText& arc_;
  std::vector<TextEdit> edits_;
};

/// Replaces an arc's statement by others, each on its own line.
/// @param line_begin of each but the first; none: as many blanks as before the first
TextEdit in_place_of_arc(const ProgramText& text, std::size_t step,
                         const std::vector<std::string>& statements,
                         const std::optional<std::string>& line_begin = std::nullopt);

/// The edits that replace each arc by statements.
template <class Statements>
std::vector<TextEdit> in_place_of_arcs(const ProgramText& text, const std::vector<ArcLines>& arcs,
                                       const Statements& statements) {
  std::vector<TextEdit> edits;
  for (const ArcLines& arc : arcs)
    edits.push_back(in_place_of_arc(text, arc.step, statements(text, arc)));
  return edits;
}

/// The last step before this one that moves to a pose: the arc's start.
std::optional<std::size_t> move_before(const ProgramText& text, std::size_t step);

/// @throw scan_cell_common::UnusableInput always, with file and line of the arc
[[noreturn]] void refuse_arc(const ProgramText& text, std::size_t step, const std::string& value,
                             const std::string& cure = "write it as lines");

/// Whether any of the words occurs in the files, in either case.
bool mentions(const std::vector<SourceFile>& files, std::initializer_list<const char*> words);

}  // namespace tool_path_programs
