// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/errors/utf8.h"

#include <fmt/format.h>

#include <boost/locale/utf.hpp>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

/// Unicode 15.0, section 23.7.
bool is_noncharacter(boost::locale::utf::code_point code) {
  return (code & 0xfffe) == 0xfffe || (code >= 0xfdd0 && code <= 0xfdef);
}

}  // namespace

void check_utf8(std::string_view text, const std::string& source, std::size_t first_line) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::size_t line = first_line;
  const char* const end = text.data() + text.size();
  for (const char* next = text.data(); next != end;) {
    const auto code = Utf8::decode(next, end);
    if (!boost::locale::utf::is_valid_codepoint(code) || is_noncharacter(code))
      throw UnusableInput(fmt::format("{}, line {}", source, line), "not UTF-8",
                          "save it as UTF-8");
    if (code == '\n') ++line;
  }
}

}  // namespace scan_cell_common
