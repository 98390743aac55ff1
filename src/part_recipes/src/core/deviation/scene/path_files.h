// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tool_paths/path_conventions.h"

namespace part_recipes {

/// What a path's file does not say about itself, as options of stretch.
struct PathReading {
  tool_paths::PathConventions conventions;     //!< of CSV and YAML
  std::string dialect;                         //!< of a robot's program
  std::vector<std::string> program_files;      //!< that the program calls
  std::set<std::string> calls_without_motion;  //!< routines that do not move the robot
  bool program_in_base = false;                //!< the path is in the robot's base
};

/// Reads a tool path from CSV, YAML or a robot's program, by the file's extension.
/// @throw scan_cell_common::Error of the reader
tool_paths::ToolPathFile load_path(const std::string& file, const PathReading& reading);

}  // namespace part_recipes
