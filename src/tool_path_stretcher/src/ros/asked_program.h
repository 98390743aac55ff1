// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/StretchToolPathAction.h>

#include <optional>
#include <string>

#include "report.h"
#include "scan_cell_common/files/temporary_folder.h"
#include "tool_path_programs/export_options.h"

namespace tool_path_stretcher {

/// The program in the robot's language that a goal requests in addition to the adapted path. It is
/// made as by export_path, from the path and report files, and read back.
class AskedProgram {
 public:
  /// @throw scan_cell_common::UnusableInput naming the file or the option that makes no sense
  explicit AskedProgram(const scan_cell_msgs::StretchToolPathGoal& goal);

  bool wanted() const { return !name_.empty(); }

  /// Saves the accepted path, so that the report can name the file it is about.
  /// @return none if it cannot be saved; write() will say so
  std::optional<FileRecord> save(const ToolPath& adapted, const std::string& units) const;

  /// Puts the program of the saved path into the result, or why there is none.
  /// @param result the result, with its report
  void write(scan_cell_msgs::StretchToolPathResult& result) const;

 private:
  std::string name_;  // of the program's main file; empty: none
  tool_path_programs::ExportOptions options_;
  std::optional<scan_cell_common::TemporaryFolder> folder_;
};

}  // namespace tool_path_stretcher
