// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_sim/ground_truth.h"
#include "tool_path_stretcher/tool_path.h"

namespace scan_cell_demo {

/// Distance of an adapted path from the true one.
struct PathError {
  double rms = 0;              //!< [m] of the positions
  double max = 0;              //!< [m]
  double orientation_rms = 0;  //!< [rad] of the angles between the orientations
};

/// @throw scan_cell_common::UnusableInput if the paths differ in their segments or waypoints
PathError compare(const tool_path_stretcher::ToolPath& path,
                  const tool_path_stretcher::ToolPath& truth);

/// Compares the lines through the waypoints instead, for a path that is its own image: each path
/// may start anywhere and run either way. Each waypoint is compared with the nearest one of the
/// other path; of the orientation only the tool's axis counts.
PathError compare_lines(const tool_path_stretcher::ToolPath& path,
                        const tool_path_stretcher::ToolPath& truth);

/// Distance of the tool's tip from the true path: RMS and maximum over the true waypoints of the
/// distance to the nearest place on the tip's way.
/// @param way places of the tip [m] in order of time, joined by straight lines
/// @return orientations are not compared: 0
/// @throw scan_cell_common::UnusableInput if one of them is empty
PathError compare_way(const std::vector<Eigen::Vector3d>& way,
                      const tool_path_stretcher::ToolPath& truth);

/// A path on the reference part, moved by the object's true deformation, scale and pose: the
/// simulator's ground truth.
/// @param reference, object world files; `part` is the part's name in both
tool_path_stretcher::ToolPath true_path(const tool_path_stretcher::ToolPath& path,
                                        const std::string& reference, const std::string& object,
                                        const std::string& part);

/// A correct path on the part of a world: scan_cell_sim::taught_path().
tool_path_stretcher::ToolPath proven_path(const std::string& world, const std::string& part);

/// Distance of a cloud in `world` from the true surfaces of a world file.
/// @throw scan_cell_common::UnusableInput if it has no point, or one that is not finite
scan_cell_sim::CloudError cloud_error(const scan_cell_common::Cloud& cloud,
                                      const std::string& world);

/// True size of the part in the object's world, relative to the reference's.
double true_scale(const std::string& reference, const std::string& object, const std::string& part);

}  // namespace scan_cell_demo
