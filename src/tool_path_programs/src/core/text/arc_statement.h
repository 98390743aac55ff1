// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// The statement of an arc with some of its pieces changed.
class ArcStatement {
 public:
  ArcStatement(const ProgramText& text, std::size_t step);

  const ArcText& pieces() const { return arc_; }
  std::string piece(const ByteRange& range) const;  //!< as it stands in the file

  ArcStatement& put(const ByteRange& range, const std::string& text);
  std::string text() const;  //!< of the statement

 private:
  const std::string& file_;
  const ArcText& arc_;
  std::vector<TextEdit> edits_;
};

/// Statements in place of that of an arc, each on a line of its own.
/// @param line_begin of each but the first; none: as many blanks as stand before the first
TextEdit in_place_of_arc(const ProgramText& text, std::size_t step,
                         const std::vector<std::string>& statements,
                         const std::optional<std::string>& line_begin = std::nullopt);

}  // namespace tool_path_programs
