// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace scan_cell {

/// A text as one line of valid UTF-8 without effect on a terminal: line ends and tabs become
/// blanks, other control characters '?', and bytes that are not UTF-8, or are control characters in
/// it, \xHH.
std::string one_line(std::string_view text);

}  // namespace scan_cell
