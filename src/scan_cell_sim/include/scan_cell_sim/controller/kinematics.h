// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

namespace scan_cell_sim {

/// Angles of the six axes [rad], Comau signs.
using Joints = Eigen::Matrix<double, 6, 1>;

/// What the axes of a Comau Smart5 SiX can do.
struct JointLimits {
  Joints lower;         //!< [rad]
  Joints upper;         //!< [rad]
  Joints speed;         //!< [rad/s]
  Joints acceleration;  //!< [rad/s^2] not published; full speed in a quarter of a second
};

const JointLimits& joint_limits();

/// Empty where all axes are within their ranges, else a text such as "J3 5 deg is outside -170 ..
/// 0".
std::string outside_limits(const Joints& joints);

/// Pose of the flange (tool0) in base_link.
Eigen::Isometry3d flange_of(const Joints& joints);

/// Joints that bring the flange there, in the posture nearest to `near`; checked by forward
/// kinematics to a nanometre and a nanoradian. Ranges are not regarded.
std::optional<Joints> joints_of(const Eigen::Isometry3d& flange, const Joints& near);

}  // namespace scan_cell_sim
