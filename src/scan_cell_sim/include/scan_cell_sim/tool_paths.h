// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "scan_cell_sim/part.h"

namespace scan_cell_sim {

/// Tool poses in world; z of each points into the surface.
using ToolPath = std::vector<Eigen::Isometry3d>;

/// A tool path as it would be taught on a frame: once around the crest of its moulding and back to
/// the start, including the corners; x of each pose points along the path.
/// @param spacing [m] on the undeformed part, above 0; the sides are cut evenly, no finer than
/// needed
/// @throw scan_cell_common::UnusableInput if the part is not a frame
/// @throw scan_cell_common::InvalidParameter if the spacing is too small or NaN
ToolPath crest_path(const Part& frame, double spacing);

/// A tool path as it would be taught on a part: around the crest of a frame, to and fro over its
/// sheet if it has one, around the top of a box and back, or along the top of an elbow; x of each
/// pose points along the path.
/// @param spacing [m] as in crest_path()
/// @throw scan_cell_common::UnusableInput if a sheet bulges by its shape instead of a deformation
/// @throw scan_cell_common::InvalidParameter if the spacing is too small or NaN
ToolPath taught_path(const Part& part, double spacing);

/// true_image() of each pose.
/// @throw as true_image()
ToolPath true_image(const Part& reference, const Part& object, const ToolPath& path);

/// Reads poses from CSV with the header x,y,z,qx,qy,qz,qw (metres, unit quaternion).
/// @throw scan_cell_common::FileError if it cannot be read
/// @throw scan_cell_common::UnusableInput naming the line that makes no sense
ToolPath load_tool_path(const std::string& path);

/// Writes poses as load_tool_path() reads them, whole or not at all.
/// @throw scan_cell_common::FileError if it cannot be written
void save_tool_path(const std::string& file, const ToolPath& path);

}  // namespace scan_cell_sim
