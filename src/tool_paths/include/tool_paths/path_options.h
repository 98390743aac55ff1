// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_paths/path_conventions.h"

namespace CLI {
class App;
}

namespace tool_paths {

/// Options of a tool about what a path's file does not say of itself.
struct PathOptions {
  bool degrees = false;         //!< angles in the path
  bool radians = false;         //!< angles in the path
  PathConventions conventions;  //!< as they are typed

  /// All that was typed.
  /// @param units of the path: m, mm or inch; empty: as its names say, else metres
  PathConventions typed(const std::string& units) const;
};

/// How orientations are written; units are up to the tool.
void add_path_options(CLI::App& app, PathOptions& options);

}  // namespace tool_paths
