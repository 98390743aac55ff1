// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters/work_parameters.h"

#include "scan_cell_common/parameters/parameter_table.h"

namespace scan_cell {

using scan_cell_common::Also;

void describe(scan_cell_common::ParameterTable& table, WorkParameters& parameters) {
  table.add("tip_frame", parameters.tip_frame, "frame of the tool's tip");
  table.add("frames", parameters.frames,
            "node whose parameters name the scanner model and the cell file: they must be those "
            "of the scan");
  table.add("max_age", parameters.rules.max_age, {1, 1e6, "s", Also::kNone},
            "of the scan that the path was adapted to");
  table.add("dry_run_first", parameters.rules.dry_run_first,
            "a proven path has to be run dry once in this cell before its first real run");
  table.add(
      "dry_runs", parameters.dry_runs,
      "file of the finished dry runs; without a folder in its name it is in ROS's own folder");
  table.add("lift", parameters.dry_run.lift, {0.001, 1, "m"}, "of a dry run, along the tool");
  table.add("dry_speed", parameters.dry_run.speed, {0.01, 1},
            "speed of a dry run, as a share of the path's");
  tool_path_programs::describe(table, parameters.process);
}

}  // namespace scan_cell
