// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "scan_cell_sim/controller/kinematics.h"

namespace scan_cell_sim {

/// x, y, z [mm], A, E, R [deg] (Euler Z-Y-Z), or six joints [deg], as on the wire.
using WireSix = std::array<double, 6>;

// Written with KDL, independently of the driver's conversion, so that an error in either shows.

/// 0 <= E <= 180, -180 < A, R <= 180; A = 0 where E is 0 or 180.
WireSix to_wire(const Eigen::Isometry3d& pose);
Eigen::Isometry3d pose_from_wire(const WireSix& wire);

WireSix to_wire(const Joints& joints);
Joints joints_from_wire(const WireSix& wire);

/// The same, rounded as in states: to 0.001 mm and 0.0001 degree.
WireSix shown(const Eigen::Isometry3d& pose);
WireSix shown(const Joints& joints);

}  // namespace scan_cell_sim
