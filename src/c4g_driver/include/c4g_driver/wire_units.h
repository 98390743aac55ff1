// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "c4g_driver/robot_state.h"

namespace c4g_driver {

/// Pose x, y, z [mm], A, E, R [deg], or six joints [deg], as on the wire.
using WireSix = std::array<double, 6>;

/// Comau's Euler angles [rad], Z-Y-Z: rotation = Rz(a) Ry(e) Rz(r).
struct EulerAngles {
  double a;
  double e;
  double r;
};

/// 0 <= e <= pi. For e = 0 and e = pi only a + r or r - a is defined: then a = 0. Exact near these
/// places too.
EulerAngles to_euler(const Eigen::Matrix3d& rotation);
Eigen::Matrix3d from_euler(const EulerAngles& angles);

WireSix to_wire(const Eigen::Isometry3d& pose);
Eigen::Isometry3d pose_from_wire(const WireSix& wire);

WireSix to_wire(const Joints& joints);
Joints joints_from_wire(const WireSix& wire);

}  // namespace c4g_driver
