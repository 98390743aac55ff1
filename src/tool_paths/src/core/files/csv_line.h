// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tool_paths {

/// Without the blanks around it.
std::string trimmed(const std::string& text);

/// The fields of a line; one in double quotes may hold commas, and quotes doubled (RFC 4180).
/// @param where file and line, for the error
/// @throw scan_cell_common::UnusableInput if a quote is not closed
std::vector<std::string> split(const std::string& line, const std::string& where);

/// A field as split() reads it. Ends of lines become blanks.
std::string quoted_where_needed(const std::string& text);

}  // namespace tool_paths
