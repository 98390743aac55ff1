// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "file_options.h"
#include "tool_paths/tool_path.h"

namespace tool_path_stretcher {

/// Options for a path given as a robot program.
struct ProgramOptions {
  std::vector<std::string> files;      //!< called by the program
  std::vector<std::string> no_motion;  //!< called routines that do not move
  std::vector<std::string> frames;     //!< NAME=x,y,z,qx,qy,qz,qw
  std::string dialect;
  bool in_base = false;
  double arc_tolerance = 1e-4;  //!< [m]
};

void add_program_options(CLI::App& app, ProgramOptions& options);

/// The path on the reference, as read from its file; writes the adapted path in the same form.
class PathInput {
 public:
  virtual ~PathInput() = default;

  /// Loads CSV, YAML or a robot program, by the file's extension.
  /// @throw scan_cell_common::Error of the reader
  static std::unique_ptr<PathInput> load(const std::string& file, const FileOptions& files,
                                         const ProgramOptions& program);

  /// Checks the output's name as save() would, before there is anything to save.
  /// @throw scan_cell_common::FileError
  static void check_output(const std::string& file, const std::string& output);

  virtual const tool_paths::ToolPath& path() const = 0;
  virtual tool_paths::PathContents contents() const = 0;

  /// Whether the adapted path may have more waypoints than the input.
  virtual bool may_be_resampled() const = 0;

  /// @return notes for the user
  /// @throw scan_cell_common::Error if the adapted path cannot be written in that form
  virtual std::vector<std::string> save(const std::string& output,
                                        const tool_paths::ToolPath& adapted) const = 0;
};

}  // namespace tool_path_stretcher
