// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_path_programs/accepted_report.h"

namespace scan_cell {

/// The cell's present calibration: SHA-256 of the files; empty: not known.
struct CalibrationNow {
  std::string scanner;
  std::string cell;
};

/// Conditions for running a path.
struct WorkRules {
  double max_age = 3600;      //!< [s] of the scan; infinite: no limit
  bool dry_run_first = true;  //!< for each proven path, before its first real run
};

/// The finished dry runs, in a file. A newly proven path, or a new calibration of tool or robot,
/// needs another dry run.
class DryRuns {
 public:
  /// @param file JSON; need not exist
  explicit DryRuns(const std::string& file) : file_(file) {}

  /// @throw scan_cell_common::Error if the file cannot be read
  bool has(const std::string& proven_path, const std::string& cell) const;

  /// @param time [s] since 1970
  /// @throw scan_cell_common::FileError if the file cannot be written
  void add(const std::string& proven_path, const std::string& cell, double time) const;

 private:
  const std::string file_;
};

/// Checks that what was accepted together is what runs.
/// @param now [s] since 1970
/// @throw scan_cell_common::Refused naming what has changed (the scanner model or the cell file),
/// or saying that the scan is too old or a dry run is missing
void check_permit(const tool_path_programs::AcceptedReport& report, const CalibrationNow& cell,
                  const WorkRules& rules, const DryRuns& dry_runs, bool dry, double now);

}  // namespace scan_cell
