// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "path_design/trace/trace.h"
#include "tool_paths/tool_path.h"

namespace part_recipes::path_design {

/// Where the z axis of a waypoint points.
enum class WaypointZ { kIntoPart, kOutOfPart };

/// How a place on the surface becomes a pose of the tool.
struct Pose {
  double stand_off = 0;                //!< [m] off the surface, along its normal
  WaypointZ z = WaypointZ::kIntoPart;  //!< direction of the z axis
  std::optional<Eigen::Vector3d> x;    //!< direction of the x axis; none: along the travel
  double corner_angle = 0.5236;        //!< [rad] of turns after which the tool stands anew
};

/// The waypoints of a stepped trace. A corner has two in one place, one for the way to it and one
/// for the way from it, if their orientations differ by more than the corner angle.
/// @throw scan_cell_common::Refused if the direction of x is along the normal
tool_paths::Segment waypoints_of(const Trace& stepped, const Pose& pose, const std::string& name);

}  // namespace part_recipes::path_design
