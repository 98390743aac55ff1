// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tool_path_programs/path_to_program.h"
#include "tool_paths/tool_path.h"

namespace scan_cell {

/// A pose to which the tool's tip moves along a line.
struct WorkWaypoint {
  Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();  //!< [m]
  double speed = 0;                                       //!< [m/s] on the way to this pose
  double zone = 0;                      //!< [m] distance at which the tip may pass it
  std::uint32_t outputs = 0;            //!< bit n: digital output n + 1 is on from here on
  std::optional<std::size_t> waypoint;  //!< of the path; none: approach, retract, or in between
};

/// The path that the robot follows. It moves to the first waypoint by its joints.
struct WorkPlan {
  Eigen::Isometry3d flange_to_tip = Eigen::Isometry3d::Identity();  //!< [m]
  double joint_speed = 0.1;  //!< to the first waypoint: share of the joints' own speeds
  std::vector<WorkWaypoint> waypoints;
};

/// The run before the first real run of a part type.
struct DryRun {
  double lift = 0.05;  //!< [m] off the part, along the tool
  double speed = 0.1;  //!< share of the path's speeds
};

/// A tool path as the robot follows it.
/// @param parameters tool_output is the output's number, 1 .. 32
/// @param in_air waypoints that are not in contact, counted over all segments
/// @param from waypoint to begin with, counted over all segments
/// @param dry lifted, slow and with all outputs off; none: the real run
/// @throw scan_cell_common::Error as program_of() of tool_path_programs; Refused if `from` is
/// beyond the path; InvalidParameter if the output is no number
WorkPlan plan_of(const tool_paths::ToolPath& path,
                 const tool_path_programs::ExportParameters& parameters,
                 const std::vector<std::size_t>& in_air, std::size_t from,
                 const std::optional<DryRun>& dry);

}  // namespace scan_cell
