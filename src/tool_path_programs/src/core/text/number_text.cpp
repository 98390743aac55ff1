// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "text/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

/// Turns -0.000 into 0.000.
void drop_sign_of_zero(std::string& text) {
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
}

}  // namespace

std::string fixed(double number, int digits) {
  std::array<char, 400> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                 std::chars_format::fixed, digits);
  std::string text(buffer.data(), end.ptr);
  drop_sign_of_zero(text);
  return text;
}

std::string shortest(double number, int digits) {
  std::string text = fixed(number, digits);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string exact(double number) {
  constexpr int kMostDigits = 17;
  std::string text;
  for (int digits = 0; digits <= kMostDigits; ++digits) {
    text = fixed(number, digits);
    if (scan_cell_common::parse_number(text) == number) break;
  }
  return text;
}

std::string like(std::string_view old_text, double number, int digits) {
  const std::size_t point = old_text.find('.');
  const std::size_t end = std::min(old_text.find_first_of("eE"), old_text.size());
  const int old_digits = point == std::string_view::npos ? 0 : static_cast<int>(end - point) - 1;
  return fixed(number, std::max(digits, old_digits));
}

}  // namespace tool_path_programs
