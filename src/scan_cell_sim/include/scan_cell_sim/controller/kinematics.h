// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace scan_cell_sim {

/// Angles of the six axes [rad], Comau signs.
using Joints = Eigen::Matrix<double, 6, 1>;

/// Limits of the axes of a Comau Smart5 SiX.
struct JointLimits {
  Joints lower;         //!< [rad]
  Joints upper;         //!< [rad]
  Joints speed;         //!< [rad/s]
  Joints acceleration;  //!< [rad/s^2] not published; full speed in a quarter of a second
};

const JointLimits& joint_limits();  //!< of the Smart5 SiX

/// Empty if all axes are within their ranges, else a text such as
/// "J3 5 deg is outside -170 .. 0".
std::string outside_limits(const Joints& joints);

/// Pose of the flange (tool0) in base_link.
Eigen::Isometry3d flange_of(const Joints& joints);

/// All postures that bring the flange to a pose, up to eight, in closed form; none if it is out of
/// reach. Ignores the ranges of the axes.
/// @param near each axis gets the full turns that bring it nearest to this within its range; it
/// also decides what a singular posture leaves undetermined
std::vector<Joints> postures_of(const Eigen::Isometry3d& flange, const Joints& near);

/// The nearest of these postures; none if the flange is out of reach.
std::optional<Joints> joints_of(const Eigen::Isometry3d& flange, const Joints& near);

/// Distance of this arm from its three singular postures. Each value changes its sign where the arm
/// passes through the posture. Their product vanishes where the determinant of the Jacobian does.
struct SingularPostures {
  double wrist;     //!< [rad] J5: at 0, axes 4 and 6 lie in line
  double elbow;     //!< [rad] bend of the elbow: at 0, the arm is stretched out to the wrist
  double shoulder;  //!< [m] of the wrist's centre from axis 1, forward
};
/// How far joints [rad] are from each kind of singular posture.
SingularPostures distance_to_singular(const Joints& joints);

}  // namespace scan_cell_sim
