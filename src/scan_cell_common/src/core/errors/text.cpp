// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/errors/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace scan_cell_common {
namespace {

template <class Number>
std::optional<Number> parse(std::string_view text) {
  Number number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return parse<double>(plus ? text.substr(1) : text);
}

std::optional<std::uint64_t> parse_count(std::string_view text) {
  return parse<std::uint64_t>(text);
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string result(text.substr(0, kMost));
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
  }
  return text.size() > kMost ? result + "..." : result;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return text.substr(0, kMark.size()) == kMark ? text.substr(kMark.size()) : text;
}

LineReader::LineReader(std::string_view text, const std::string& source)
    : text_(text), source_(source) {}

bool LineReader::next() {
  words_.clear();
  if (position_ == text_.size()) return false;
  ++line_;
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  std::size_t at = position_;
  while (true) {
    while (at < end && is_blank(text_[at]))
      ++at;
    if (at == end) break;
    const std::size_t begin = at;
    while (at < end && !is_blank(text_[at]))
      ++at;
    words_.push_back(text_.substr(begin, at - begin));
  }
  position_ = std::min(end + 1, text_.size());
  return true;
}

bool LineReader::next_filled() {
  while (next()) {
    if (!words_.empty()) return true;
  }
  return false;
}

std::string LineReader::where() const {
  return fmt::format("{}, line {}", source_, line_);
}

}  // namespace scan_cell_common
