// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tool_paths {

/// The text without surrounding blanks.
std::string trimmed(const std::string& text);

/// The fields of a line. A field in double quotes may contain commas, and doubled quotes (RFC
/// 4180).
/// @param where file and line, for the error
/// @throw scan_cell_common::UnusableInput if a quote is not closed
std::vector<std::string> split(const std::string& line, const std::string& where);

/// A field that split() reads back. Line ends become blanks.
std::string quoted_where_needed(const std::string& text);

}  // namespace tool_paths
