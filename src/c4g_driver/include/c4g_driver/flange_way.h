// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace c4g_driver {

/// Poses of the flange along one motion as MotionCheck follows it, both ends included, at most a
/// few millimetres and a degree apart.
/// @param via pose that an arc passes (MOVE_CIRCULAR); none: a line, along which the orientation
/// turns about one axis
/// @throw scan_cell_common::Refused if no arc passes through the three poses
std::vector<Eigen::Isometry3d> flange_way(const Eigen::Isometry3d& from,
                                          const std::optional<Eigen::Isometry3d>& via,
                                          const Eigen::Isometry3d& to);

}  // namespace c4g_driver
