// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "text/token_reader.h"

#include <algorithm>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {

using scan_cell_common::lower_case;

TokenReader::TokenReader(const SourceFile& file, std::size_t file_index,
                         const std::vector<Token>& tokens)
    : file_(file), file_index_(file_index), tokens_(tokens) {
  pass_comments();
}

void TokenReader::pass_comments() {
  while (tokens_[at_].kind == TokenKind::kComment)
    ++at_;
}

const Token& TokenReader::peek_after() const {
  std::size_t after = at_;
  while (tokens_[after].kind != TokenKind::kEnd)
    if (tokens_[++after].kind != TokenKind::kComment) break;
  return tokens_[after];
}

const Token& TokenReader::next() {
  const Token& token = tokens_[at_];
  end_of_last_ = token.offset + token.text.size();
  if (token.kind != TokenKind::kEnd) ++at_;
  pass_comments();
  return token;
}

void TokenReader::go_to(std::size_t position) {
  at_ = position;
  pass_comments();
}

void TokenReader::go_to_byte(std::size_t offset) {
  const auto found =
      std::lower_bound(tokens_.begin(), tokens_.end(), offset,
                       [](const Token& token, std::size_t byte) { return token.offset < byte; });
  go_to(static_cast<std::size_t>(found - tokens_.begin()));
}

bool TokenReader::at_symbol(char symbol) const {
  return peek().kind == TokenKind::kSymbol && peek().text.front() == symbol;
}

bool TokenReader::at_name(std::string_view name) const {
  return peek().kind == TokenKind::kName && peek().text.size() == name.size() &&
         lower_case(peek().text) == lower_case(name);
}

bool TokenReader::accept(char symbol) {
  if (!at_symbol(symbol)) return false;
  next();
  return true;
}

bool TokenReader::accept(std::string_view name) {
  if (!at_name(name)) return false;
  next();
  return true;
}

void TokenReader::expect(char symbol) {
  if (!accept(symbol)) fail(here(), std::string("expected '") + symbol + "'");
}

void TokenReader::expect(std::string_view name) {
  if (!accept(name)) fail(here(), "expected " + std::string(name));
}

std::string TokenReader::name() {
  if (peek().kind != TokenKind::kName) fail(here(), "expected a name");
  return std::string(next().text);
}

NumberText TokenReader::number() {
  const std::size_t offset = peek().offset;
  const bool minus = at_symbol('-');
  if (minus || at_symbol('+')) next();
  if (peek().kind != TokenKind::kNumber)
    fail(here(), "expected a number; computed values are not known here");
  const Token& digits = next();
  return {minus ? -digits.number : digits.number, offset,
          digits.offset + digits.text.size() - offset};
}

void TokenReader::skip_line() {
  while (!at_line_end())
    next();
  if (!at_end()) next();
}

Place TokenReader::place() const {
  return {file_index_, peek().line};
}

std::string TokenReader::where() const {
  return file_.name + ", line " + std::to_string(peek().line);
}

void TokenReader::fail(const std::string& value, const std::string& cure) const {
  throw scan_cell_common::UnusableInput(where(), value, cure);
}

std::string TokenReader::here() const {
  if (at_end()) return "the file ends";
  if (at_line_end()) return "the line ends";
  return scan_cell_common::excerpt(peek().text);
}

}  // namespace tool_path_programs
