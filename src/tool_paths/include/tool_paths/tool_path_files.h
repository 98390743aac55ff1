// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_paths/path_conventions.h"
#include "tool_paths/tool_path.h"

namespace tool_paths {

/// Reads a tool path from CSV or YAML, by the file's extension. docs/tool_path_stretcher.md
/// describes both formats.
/// @throw scan_cell_common::FileError if it is missing or unreadable
/// @throw scan_cell_common::UnusableInput naming file and line of anything that makes no sense,
/// including what could be an orientation but is of unknown kind
/// @throw scan_cell_common::InvalidParameter if the conventions make no sense or do not fit the
/// file
ToolPathFile load_tool_path_file(const std::string& path, const PathConventions& conventions = {});

/// The same, returning only the path.
ToolPath load_tool_path(const std::string& path, const PathConventions& conventions = {});

/// Writes a tool path as CSV or YAML, by the file's extension; whole or not at all. Numbers in
/// metres and radians read back to the last digit.
/// @param layout of the file it came from: keeps units, orientations, columns or YAML. If that file
/// has the other format, only the names and conventions of its poses are kept.
/// @throw scan_cell_common::FileError if it cannot be written or the extension is neither
void save_tool_path(const std::string& path, const ToolPath& tool_path,
                    const PathLayout& layout = {});

/// Checks a name as save_tool_path() would, before there is anything to save.
/// @throw scan_cell_common::FileError if the extension is neither .csv nor .yaml, or the folder
/// does not exist
void check_tool_path_name(const std::string& path);

/// The parsers used by load_tool_path_file(); `source` names the text in errors.
ToolPathFile parse_tool_path_csv(const std::string& text, const std::string& source,
                                 const PathConventions& conventions = {});
/// As parse_tool_path_csv().
ToolPathFile parse_tool_path_yaml(const std::string& text, const std::string& source,
                                  const PathConventions& conventions = {});

/// The text of a CSV file.
std::string tool_path_to_csv(const ToolPath& path, const PathLayout& layout = {});
/// The text of a YAML file.
std::string tool_path_to_yaml(const ToolPath& path, const PathLayout& layout = {});
/// The YAML that noether reads and writes: a list of tool paths (here one), each a list of
/// segments, each a list of waypoints {x, y, z, qw, qx, qy, qz}. Process values are lost.
/// @throw scan_cell_common::UnusableInput if the path has no orientations
std::string tool_path_to_noether_yaml(const ToolPath& path);

}  // namespace tool_paths
