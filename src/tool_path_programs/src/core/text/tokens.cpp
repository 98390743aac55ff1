// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "text/tokens.h"

#include <algorithm>
#include <charconv>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

bool is_digit(char character) {
  return character >= '0' && character <= '9';
}

bool is_letter(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
         character == '_';
}

class Tokenizer {
 public:
  Tokenizer(const SourceFile& file, const LexicalRules& rules)
      : file_(file), text_(file.text), rules_(rules) {}

  std::vector<Token> run() {
    while (pass_blanks(), at_ < text_.size())
      add();
    tokens_.push_back({TokenKind::kEnd, {}, 0, at_, line_});
    return std::move(tokens_);
  }

 private:
  void add() {
    const char first = text_[at_];
    if (first == '\n') {
      add(TokenKind::kLineEnd, 1);
      ++line_;
    } else if (at_comment()) {
      add(TokenKind::kComment, to_line_end());
    } else if (is_digit(first) ||
               (first == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
      add_number();
    } else if (begins_name(first)) {
      add(TokenKind::kName, length_of_name());
    } else if (rules_.quotes.find(first) != std::string::npos) {
      add(TokenKind::kText, length_of_text());
    } else {
      add(TokenKind::kSymbol, 1);
    }
  }

  void add(TokenKind kind, std::size_t length, double number = 0) {
    tokens_.push_back({kind, text_.substr(at_, length), number, at_, line_});
    at_ += length;
  }

  void pass_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r'))
      ++at_;
  }

  bool at_comment() const {
    return std::any_of(
        rules_.comment_marks.begin(), rules_.comment_marks.end(),
        [&](const std::string& mark) { return text_.compare(at_, mark.size(), mark) == 0; });
  }

  std::size_t to_line_end() const {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    return (end > at_ && text_[end - 1] == '\r' ? end - 1 : end) - at_;
  }

  bool begins_name(char character) const {
    return is_letter(character) || rules_.name_characters.find(character) != std::string::npos;
  }

  std::size_t length_of_name() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && (begins_name(text_[end]) || is_digit(text_[end])))
      ++end;
    return end - at_;
  }

  std::size_t length_of_text() const {
    const char quote = text_[at_];
    const std::size_t line_end = at_ + to_line_end();
    for (std::size_t end = at_ + 1; end < line_end; ++end) {
      if (text_[end] != quote) continue;
      if (end + 1 >= line_end || text_[end + 1] != quote) return end + 1 - at_;
      ++end;
    }
    fail("a quote is not closed on its line");
  }

  void add_number() {
    double number = 0;
    const char* begin = text_.data() + at_;
    const auto end = std::from_chars(begin, text_.data() + text_.size(), number);
    if (end.ec != std::errc()) fail("a number that cannot be read");
    add(TokenKind::kNumber, static_cast<std::size_t>(end.ptr - begin), number);
  }

  [[noreturn]] void fail(const std::string& value) const {
    throw scan_cell_common::UnusableInput(
        file_.name + ", line " + std::to_string(line_),
        value + ": " + scan_cell_common::excerpt(text_.substr(at_, to_line_end())),
        "give a program that its controller accepts");
  }

  const SourceFile& file_;
  const std::string_view text_;
  const LexicalRules& rules_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(const SourceFile& file, const LexicalRules& rules) {
  return Tokenizer(file, rules).run();
}

}  // namespace tool_path_programs
