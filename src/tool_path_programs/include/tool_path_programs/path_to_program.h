// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_programs/program.h"
#include "tool_paths/tool_path.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace tool_path_programs {

/// Direction of the z axis of a path's waypoints.
enum class WaypointZ { kNotGiven, kIntoPart, kOutOfPart };

/// How a tool path becomes a program.
struct ExportParameters {
  std::string name = "ADAPTED";                 //!< of the program
  WaypointZ waypoint_z = WaypointZ::kNotGiven;  //!< the robot's tool z points into the part
  std::string speed_value = "speed";            //!< process value that holds the speed
  std::string speed_unit = "m/s";               //!< of that process value
  double speed = 0.05;                          //!< [m/s] if the path has no such process value
  double travel_speed = 0.25;                   //!< [m/s] between segments, approach and retract
  double joint_speed = 0.1;                     //!< share, on the way to the first approach
  double zone = 0.001;                          //!< [m] within a segment; it stops at the ends
  double approach = 0.05;                       //!< [m] before each segment, along the tool
  double retract = 0.05;                        //!< [m] after each segment, along the tool
  std::string tool_output;                      //!< digital output of the tool; empty: none
};

/// Adds each parameter with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, ExportParameters& parameters);

/// Makes a program of a tool path: for each segment an approach, its waypoints and a retract. The
/// first approach is a joint move, all other moves are lines. In each segment the output is on from
/// the first to the last waypoint in contact.
/// @param in_air waypoints that are not in contact, counted over all segments
/// @throw scan_cell_common::UnusableInput if the path is invalid, or a waypoint's speed is not
/// above 0
/// @throw scan_cell_common::InvalidParameter if a parameter is out of its range, or waypoint_z is
/// missing for a path with orientations
Program program_of(const tool_paths::ToolPath& path, const ExportParameters& parameters,
                   const Frames& frames, const std::vector<std::size_t>& in_air = {});

}  // namespace tool_path_programs
