// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace scan_calibration {

/// Requirements on a taught world frame.
struct WorldFrameLimits {
  double min_distance = 0.05;  //!< [m] from O to X, and from XY to the X axis; chosen
  double max_skew = 0.05;  //!< [rad] by which the angle O-X-XY may differ from a right one; chosen
};

/// The world frame in the frame of the taught points.
struct WorldFrame {
  Eigen::Isometry3d pose;  //!< of world
  double skew;             //!< [rad] error of the right angle O-X-XY: how well it was taught
};

/// World frame from three taught points (thesis 5.4): `o` is the origin, `x` any point on the X
/// axis, `xy` any point on the parallel to the Y axis through `x`, on its positive side. z = x
/// cross y.
/// @param o, x, xy [m] positions of the tool's tip, in base_link
/// @throw scan_cell_common::UnusableInput, with the figure, if points coincide, lie nearly on one
/// line, or do not form a right angle
WorldFrame world_from_points(const Eigen::Vector3d& o, const Eigen::Vector3d& x,
                             const Eigen::Vector3d& xy, const WorldFrameLimits& limits = {});

}  // namespace scan_calibration
