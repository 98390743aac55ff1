// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_path_stretcher/tool_path.h"

namespace tool_path_stretcher {

/// Reads a tool path in metres from CSV or YAML, by the file's ending. docs/tool_path_stretcher.md
/// describes both formats.
/// @throw scan_cell_common::FileError if it is missing or unreadable
/// @throw scan_cell_common::UnusableInput naming file and line of what makes no sense
ToolPath load_tool_path(const std::string& path);

/// Writes a tool path as CSV or YAML, by the file's ending; whole or not at all. Numbers come back
/// to the last digit.
/// @throw scan_cell_common::FileError if it cannot be written or the ending is neither
void save_tool_path(const std::string& path, const ToolPath& tool_path);

/// @throw scan_cell_common::FileError unless a tool path can be kept under this name: .csv or .yaml
void check_tool_path_name(const std::string& path);

/// The parsers behind load_tool_path(); `source` names the text in errors.
ToolPath parse_tool_path_csv(const std::string& text, const std::string& source);
ToolPath parse_tool_path_yaml(const std::string& text, const std::string& source);

std::string tool_path_to_csv(const ToolPath& path);
std::string tool_path_to_yaml(const ToolPath& path);

}  // namespace tool_path_stretcher
