// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe/one_line.h"

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <cstdio>

namespace scan_cell {
namespace {

using Utf8 = boost::locale::utf::utf_traits<char>;

/// The first character of a text in the form allowed in the line.
std::string_view character(std::string_view text) {
  constexpr char32_t kBlank = ' ', kDelete = 0x7f, kLastControl = 0x9f;  // of Unicode's C0 and C1
  const char* next = text.data();
  const auto code = Utf8::decode(next, text.data() + text.size());
  if (!boost::locale::utf::is_valid_codepoint(code)) return "";
  if (code == '\n' || code == '\r' || code == '\t') return " ";
  if (code < kBlank || code == kDelete) return "?";
  if (code > kDelete && code <= kLastControl) return "";
  return text.substr(0, static_cast<std::size_t>(next - text.data()));
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::string_view good = character(text);
    if (good.empty()) {
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\x%02X", static_cast<unsigned char>(text[0]));
      line += escaped;
    } else {
      line += good;
    }
    text.remove_prefix(std::max<std::size_t>(1, good.size()));
  }
  return line;
}

}  // namespace scan_cell
