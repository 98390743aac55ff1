// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace scan_cell_common {

/// Nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
Eigen::Vector3d nearest_on_triangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                                    const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace scan_cell_common
