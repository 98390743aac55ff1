// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "scan_cell_common/pose/euler_angles.h"

namespace scan_cell_common {

/// A pose as Comau's controllers and teach pendants write it: x, y, z [mm], A, E, R [deg].
using WireSix = std::array<double, 6>;

/// Comau's Euler angles, Z-Y-Z: rotation = Rz(A) Ry(E) Rz(R), 0 <= E <= pi; A = 0 if E is 0 or pi.
const EulerSequence& comau_angles();

/// @param pose [m]
WireSix to_wire(const Eigen::Isometry3d& pose);

/// @return [m]
Eigen::Isometry3d pose_from_wire(const WireSix& wire);

}  // namespace scan_cell_common
