// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tool_path_programs/source_text.h"

namespace tool_path_programs {

/// How a language's text is split into tokens. Blanks separate them; line ends are tokens.
struct LexicalRules {
  std::vector<std::string> comment_marks;  //!< begin a comment to the end of the line: ";", "--"
  std::string quotes;           //!< each opens a text that ends with the same one, doubled inside
  std::string name_characters;  //!< allowed in names besides letters, digits and "_", such as "$"
};

enum class TokenKind {
  kName,     // begins with a letter, "_" or one of name_characters
  kNumber,   // without sign: 12, 0.5, .5, 1e-3
  kText,     // in quotes
  kSymbol,   // one character
  kComment,  // with its mark, without the line end
  kLineEnd,
  kEnd,  // the last one
};

/// A piece of a file's text; valid as long as the file's text is.
struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::string_view text;   // kText: with its quotes
  double number = 0;       // of kNumber
  std::size_t offset = 0;  // of its first byte
  std::size_t line = 1;    // from 1
};

/// @throw scan_cell_common::UnusableInput naming file and line of a quote that is not closed on its
/// line, or of an invalid number
std::vector<Token> tokens_of(const SourceFile& file, const LexicalRules& rules);

}  // namespace tool_path_programs
