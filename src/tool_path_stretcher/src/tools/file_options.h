// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_paths/path_options.h"

namespace CLI {
class App;
}

namespace tool_path_stretcher {

/// Options for what the files do not tell.
struct FileOptions {
  std::string units;  //!< of all files; empty: metres
  std::string reference_units;
  std::string object_units;
  std::string path_units;
  tool_paths::PathOptions path;

  /// The unit of a file: its own option, else that of all files, else metres.
  std::string units_of_reference() const;
  std::string units_of_object() const;

  /// The conventions of the tool path.
  tool_paths::PathConventions path_conventions() const;
};

void add_file_options(CLI::App& app, FileOptions& options);

}  // namespace tool_path_stretcher
