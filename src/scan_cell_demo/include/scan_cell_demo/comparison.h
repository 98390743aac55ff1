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

/// How far an adapted path lies from the true one.
struct PathError {
  double rms = 0;              //!< [m] of the positions
  double max = 0;              //!< [m]
  double orientation_rms = 0;  //!< [rad] of the angles between the orientations
};

/// @throw scan_cell_common::UnusableInput if the paths differ in their segments or waypoints
PathError compare(const tool_path_stretcher::ToolPath& path,
                  const tool_path_stretcher::ToolPath& truth);

/// The same of the lines that the waypoints lie on, wherever and whichever way round each starts:
/// for a path that is its own image. Each waypoint is compared with the nearest of the other path,
/// and of the orientation the tool's axis.
PathError compare_lines(const tool_path_stretcher::ToolPath& path,
                        const tool_path_stretcher::ToolPath& truth);

/// How far the tool's tip went from the true path: of each true waypoint the distance to the
/// nearest place of the way that the tip went, and of the farthest waypoint.
/// @param way places of the tip [m] in the order of time; it went straight between them
/// @return orientations are not compared: 0
/// @throw scan_cell_common::UnusableInput if one of them is empty
PathError compare_way(const std::vector<Eigen::Vector3d>& way,
                      const tool_path_stretcher::ToolPath& truth);

/// A path on the reference part, carried to where the object's deformation, scale and pose truly
/// take it: the simulator's ground truth.
/// @param reference, object world files; `part` is the part's name in both
tool_path_stretcher::ToolPath true_path(const tool_path_stretcher::ToolPath& path,
                                        const std::string& reference, const std::string& object,
                                        const std::string& part);

/// A path that is right on the part of that world: scan_cell_sim::taught_path().
tool_path_stretcher::ToolPath proven_path(const std::string& world, const std::string& part);

/// How far a cloud in `world` is from the true surfaces of a world file.
/// @throw scan_cell_common::UnusableInput if it has no point, or one that is not finite
scan_cell_sim::CloudError cloud_error(const scan_cell_common::Cloud& cloud,
                                      const std::string& world);

/// How much larger the part truly is in the object's world than in the reference's.
double true_scale(const std::string& reference, const std::string& object, const std::string& part);

}  // namespace scan_cell_demo
