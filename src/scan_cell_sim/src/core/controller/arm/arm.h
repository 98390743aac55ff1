// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

/// The arm of a Comau Smart5 SiX. Uses the data sheet's lengths and not the URDF, so that an error
/// in either shows.
namespace scan_cell_sim {

// [m] Denavit and Hartenberg, data sheet
constexpr double kD1 = 0.450, kA1 = 0.150, kA2 = 0.590, kA3 = 0.130, kD4 = 0.64707, kD6 = 0.095;

const double kForearm = std::hypot(kA3, kD4);       // [m] from axis 3 to the wrist's centre
const double kForearmAngle = std::atan2(kA3, kD4);  // [rad] of that line above the forearm

/// Orientation of the flange in the last axis' frame, whose x lies along the forearm. The flange's
/// z lies along it; with the wrist straight and the forearm level, x is up.
inline Eigen::Matrix3d flange_turn() {
  return (Eigen::Matrix3d() << 0, 0, 1, 0, -1, 0, 1, 0, 0).finished();
}

}  // namespace scan_cell_sim
