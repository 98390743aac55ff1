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

/// The program in the robot's language that a goal asks for beside the adapted path. It is made as
/// export_path makes it, from the path and its report as files, and read back.
class AskedProgram {
 public:
  /// @throw scan_cell_common::UnusableInput naming the file or the option that makes no sense
  explicit AskedProgram(const scan_cell_msgs::StretchToolPathGoal& goal);

  bool wanted() const { return !name_.empty(); }

  /// Saves the accepted path, so that the report can say of which file it speaks.
  /// @return none if it cannot be saved; write() will say so
  std::optional<FileRecord> save(const ToolPath& adapted, const std::string& units) const;

  /// Writes the program of the saved path into the result, or why there is none.
  /// @param result with its report
  void write(scan_cell_msgs::StretchToolPathResult& result) const;

 private:
  std::string name_;  // of its main file; empty: none
  tool_path_programs::ExportOptions options_;
  std::optional<scan_cell_common::TemporaryFolder> folder_;
};

}  // namespace tool_path_stretcher
