// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace c4g_driver {

/// Poses of the flange in one motion, its ends included, a few millimetres and a degree apart at
/// most: as MotionCheck follows it.
/// @param via the pose on the way of an arc (MOVE_CIRCULAR); none: a line, along which the
/// orientation turns about one axis
/// @throw scan_cell_common::Refused if the three poses have no arc
std::vector<Eigen::Isometry3d> flange_way(const Eigen::Isometry3d& from,
                                          const std::optional<Eigen::Isometry3d>& via,
                                          const Eigen::Isometry3d& to);

}  // namespace c4g_driver
