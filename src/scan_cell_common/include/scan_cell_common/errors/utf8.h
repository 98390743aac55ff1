// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace scan_cell_common {

/// @param source names the text in errors
/// @param first_line number of the text's first line in its source
/// @throw UnusableInput with the line of the first bytes that are not UTF-8, or are a code point
/// that Unicode reserves as no character (U+FFFE, U+FDD0 and others): YAML and JSON replace both
void check_utf8(std::string_view text, const std::string& source, std::size_t first_line = 1);

}  // namespace scan_cell_common
