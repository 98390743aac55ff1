// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/tokens.h"

namespace tool_path_programs {

/// A number in a text, with its sign.
struct NumberText {
  double value = 0;
  std::size_t offset = 0;
  std::size_t length = 0;
};

/// Reads the tokens of a file in order. Comments are skipped.
class TokenReader {
 public:
  /// Both must outlive it.
  TokenReader(const SourceFile& file, std::size_t file_index, const std::vector<Token>& tokens);

  const Token& peek() const { return tokens_[at_]; }  //!< kEnd at the end
  const Token& peek_after() const;                    //!< the one after it
  const Token& next();                                //!< the one that peek() gave

  std::size_t position() const { return at_; }  //!< of peek() among the tokens
  void go_to(std::size_t position);             //!< to a former position(), skips comments there
  void go_to_byte(std::size_t offset);          //!< to the first token that begins there or later

  bool at_end() const { return peek().kind == TokenKind::kEnd; }
  bool at_line_end() const { return at_end() || peek().kind == TokenKind::kLineEnd; }
  bool at_symbol(char symbol) const;
  bool at_name(std::string_view name) const;  //!< ignores case

  bool accept(char symbol);            //!< goes on if it is next
  bool accept(std::string_view name);  //!< ignores case

  /// Each throws scan_cell_common::UnusableInput naming file, line, what was found and what was
  /// expected.
  void expect(char symbol);
  void expect(std::string_view name);
  std::string name();
  NumberText number();  //!< with a sign

  void skip_line();                                         //!< to the beginning of the next line
  Place place() const;                                      //!< of the next token
  std::size_t offset() const { return peek().offset; }      //!< of the next token
  std::size_t end_of_last() const { return end_of_last_; }  //!< end of the token that next() gave
  std::string where() const;                                //!< of the next token, for errors
  [[noreturn]] void fail(const std::string& value, const std::string& cure) const;

 private:
  void pass_comments();
  std::string here() const;

  const SourceFile& file_;
  std::size_t file_index_;
  const std::vector<Token>& tokens_;
  std::size_t at_ = 0;
  std::size_t end_of_last_ = 0;
};

}  // namespace tool_path_programs
