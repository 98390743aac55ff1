// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/parameters/parameter_table.h"
#include "tool_path_programs/path_to_program.h"

namespace tool_path_programs {

void describe(scan_cell_common::ParameterTable& table, ExportParameters& parameters) {
  table.choice("waypoint_z", parameters.waypoint_z, {"not_given", "into_part", "out_of_part"},
               "where the z axis of the path's waypoints points; that of the robot's tool points "
               "into the part");
  table.add("speed_value", parameters.speed_value,
            "process value of the path that holds the speed on the way to its waypoint");
  table.choice("speed_unit", parameters.speed_unit, {"m/s", "mm/s", "m/min", "mm/min"},
               "unit of that process value");
  table.add("speed", parameters.speed, {1e-6, 10, "m/s"},
            "speed of a path without that process value");
  table.add("travel_speed", parameters.travel_speed, {1e-6, 10, "m/s"},
            "speed between segments, to them and away from them");
  table.add("joint_speed", parameters.joint_speed, {0.001, 1},
            "speed of the move to the first approach: share of the axes' own speed");
  table.add("zone", parameters.zone, {0, 1, "m"},
            "how far from a waypoint the tool may leave its lines, so that it need not stop there; "
            "at most 45 % of the way to a neighbour; at the ends of segments it stops");
  table.add("approach", parameters.approach, {0, 10, "m"},
            "length of the approach in front of each segment, along the tool's axis");
  table.add("retract", parameters.retract, {0, 10, "m"},
            "length of the retract behind each segment, along the tool's axis");
  table.add("tool_output", parameters.tool_output,
            "digital output that switches the tool, as the language names it; empty: none");
}

}  // namespace tool_path_programs
