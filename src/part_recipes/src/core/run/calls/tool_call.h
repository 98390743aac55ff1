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

/// A command-line tool of the suite, called as a person would. It runs in its own process, so that
/// nothing it does can leave a run half written.
struct ToolCall {
  std::string stage;                 //!< name of its record and its log
  std::string package;               //!< that the tool belongs to
  std::vector<std::string> command;  //!< tool, then its arguments
};

/// Adds the options to a call: {"min_scale": "0.9"} as --min-scale 0.9; true as the option alone;
/// false is left out.
void add_options(ToolCall& call, const ToolOptions& options);

/// Path of the tool's program: beside this program's package, in the workspace or installed.
/// @throw scan_cell_common::FileError if it is not there
std::filesystem::path program_of(const std::string& package, const std::string& tool);

/// Returns true when the work shall end.
using Stop = std::function<bool()>;

/// Calls the tool and waits for its end.
/// @param folder in which it works
/// @param log gets everything that it prints
/// @param stop asked a few times a second; if true, the tool is told to end, as by Ctrl-C
/// @throw scan_cell_common::FileError if it cannot be called
StageRecord run_tool(const ToolCall& call, const std::filesystem::path& folder,
                     const std::filesystem::path& log, const Stop& stop);

/// The last line of a log that is not empty.
std::string last_line(const std::filesystem::path& log);

}  // namespace part_recipes
