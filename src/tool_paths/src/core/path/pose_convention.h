// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "tool_paths/path_conventions.h"

namespace tool_paths {

/// The convention of a file, or of a new one: quaternions if the path has orientations.
PoseConvention convention_for(const ToolPath& path, const PoseConvention& convention);

/// How many numbers a pose has: 3 for the position, then those of the orientation.
std::size_t number_count(const PoseConvention& convention);

/// A pose [m] from its numbers, in the order of the convention's names.
/// @param where file and line, for the error
/// @throw scan_cell_common::UnusableInput if a quaternion or a tool vector is not of unit length
Eigen::Isometry3d pose_from(const PoseConvention& convention, const std::vector<double>& numbers,
                            const std::string& where);

/// The inverse of pose_from().
/// @param rotation of the pose, in the wanted hemisphere
std::vector<double> numbers_of(const PoseConvention& convention, const Eigen::Vector3d& position,
                               const Eigen::Quaterniond& rotation);

/// Tool vectors leave the rotation about them open. Carries it along from waypoint to waypoint, so
/// that interpolated rotations turn the vectors along the shorter arc.
void carry_spin_along(Segment& segment);

/// @throw scan_cell_common::UnusableInput if angles given as degrees are actually radians
void check_angles(const PoseConvention& convention, const std::vector<double>& angles,
                  const std::string& source);

}  // namespace tool_paths
