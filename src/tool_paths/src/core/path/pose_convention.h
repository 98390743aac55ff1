// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "tool_paths/path_conventions.h"

namespace tool_paths {

/// The convention of a file, or that of a new one: quaternions where the path has orientations.
PoseConvention convention_for(const ToolPath& path, const PoseConvention& convention);

/// Of a pose's numbers: 3 of position, then those of the orientation.
std::size_t number_count(const PoseConvention& convention);

/// A pose [m] from its numbers, in the order of the convention's names.
/// @param where file and line, for the error
/// @throw scan_cell_common::UnusableInput if a quaternion or a tool vector is not of unit length
Eigen::Isometry3d pose_from(const PoseConvention& convention, const std::vector<double>& numbers,
                            const std::string& where);

/// The other way round.
/// @param rotation the pose's, in the hemisphere that is wanted
std::vector<double> numbers_of(const PoseConvention& convention, const Eigen::Vector3d& position,
                               const Eigen::Quaterniond& rotation);

/// Tool vectors leave the spin about them open: from waypoint to waypoint it is carried along, so
/// that what interpolates the rotations turns the vectors the short way.
void carry_spin_along(Segment& segment);

/// @throw scan_cell_common::UnusableInput if angles in degrees are in truth radians
void check_angles(const PoseConvention& convention, const std::vector<double>& angles,
                  const std::string& source);

}  // namespace tool_paths
