// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_path_programs/path_to_program.h"
#include "work/work_permit.h"
#include "work/work_plan.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace scan_cell {

/// Parameters of the action ~work.
struct WorkParameters {
  tool_path_programs::ExportParameters process;  //!< speeds, zones, approach, output
  DryRun dry_run;
  WorkRules rules;
  std::string tip_frame = "tool_tip";
  std::string frames = "/calibrated_frames";  //!< node with the calibration's files
  std::string dry_runs = "dry_runs.json";     //!< file with the finished dry runs
};

/// Adds each parameter with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, WorkParameters& parameters);

}  // namespace scan_cell
