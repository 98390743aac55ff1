// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_paths/path_conventions.h"

namespace CLI {
class App;
}

namespace tool_paths {

/// Options of a command for what a path's file does not tell.
struct PathOptions {
  bool degrees = false;         //!< angles in the path
  bool radians = false;         //!< angles in the path
  PathConventions conventions;  //!< as typed

  /// All conventions as typed.
  /// @param units of the path: m, mm or inch; empty: from its names, else metres
  PathConventions typed(const std::string& units) const;
};

/// Adds the options for orientations. Options for units are left to the tool.
void add_path_options(CLI::App& app, PathOptions& options);

}  // namespace tool_paths
