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

/// Options about a path that is a robot's program.
struct ProgramOptions {
  std::vector<std::string> files;      //!< that the program calls
  std::vector<std::string> no_motion;  //!< routines that it calls and that do not move
  std::vector<std::string> frames;     //!< NAME=x,y,z,qx,qy,qz,qw
  std::string dialect;
  bool in_base = false;
  double arc_tolerance = 1e-4;  //!< [m]
};

void add_program_options(CLI::App& app, ProgramOptions& options);

/// The path on the reference, as the file that holds it, and its adapted counterpart in the same
/// form.
class PathInput {
 public:
  virtual ~PathInput() = default;

  /// CSV, YAML or a robot's program, by the file's ending.
  /// @throw scan_cell_common::Error of the reader
  static std::unique_ptr<PathInput> load(const std::string& file, const FileOptions& files,
                                         const ProgramOptions& program);

  /// What save() would refuse of the output's name, before there is anything to save.
  /// @throw scan_cell_common::FileError
  static void check_output(const std::string& file, const std::string& output);

  virtual const tool_paths::ToolPath& path() const = 0;
  virtual tool_paths::PathContents contents() const = 0;

  /// Whether the adapted path may have more waypoints.
  virtual bool may_be_resampled() const = 0;

  /// @return what the person should know
  /// @throw scan_cell_common::Error if the adapted path cannot be written in that form
  virtual std::vector<std::string> save(const std::string& output,
                                        const tool_paths::ToolPath& adapted) const = 0;
};

}  // namespace tool_path_stretcher
