// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "recipe/recipe.h"
#include "record/run_record.h"

namespace part_recipes {

/// A command-line tool of the suite, called as a person would. It is a process of its own, so that
/// nothing that it does can leave a run half written.
struct ToolCall {
  std::string stage;                 //!< name of its record and its log
  std::string package;               //!< that the tool belongs to
  std::vector<std::string> command;  //!< tool, then its arguments
};

/// Adds the options to a call: {"min_scale": "0.9"} as --min-scale 0.9; true as the option alone,
/// false not at all.
void add_options(ToolCall& call, const ToolOptions& options);

/// Where the tool's program is: beside this program's package, in the workspace or installed.
/// @throw scan_cell_common::FileError if it is not there
std::filesystem::path program_of(const std::string& package, const std::string& tool);

/// Whether the work shall end now.
using Stop = std::function<bool()>;

/// Calls it and waits for its end.
/// @param folder that it works in
/// @param log gets all that it prints
/// @param stop asked some times a second; the tool is told to end then, as by Ctrl-C
/// @throw scan_cell_common::FileError if it cannot be called
StageRecord run_tool(const ToolCall& call, const std::filesystem::path& folder,
                     const std::filesystem::path& log, const Stop& stop);

/// The last line of a log that says something.
std::string last_line(const std::filesystem::path& log);

}  // namespace part_recipes
