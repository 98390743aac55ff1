// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "deviation/scene/path_files.h"
#include "tool_paths/path_options.h"

namespace part_recipes {

/// Options typed for reading a path.
struct PathReadingOptions {
  std::string units;  //!< m, mm or inch; empty: as the file's names say, else metres
  tool_paths::PathOptions conventions;
  PathReading reading;
  std::vector<std::string> no_motion;

  PathReading typed() const;
};

/// Adds the options of a tool that reads a path, except its units.
void add_reading_options(CLI::App& app, PathReadingOptions& options);

}  // namespace part_recipes
