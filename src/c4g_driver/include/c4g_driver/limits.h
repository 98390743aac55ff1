// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "c4g_driver/robot_state.h"

namespace c4g_driver {

/// What may be asked of the robot.
struct RobotLimits {
  /// A Comau Smart5 SiX on the floor, with the bracket clear of it.
  RobotLimits();

  Joints joint_lower;                 //!< [rad]
  Joints joint_upper;                 //!< [rad]
  Eigen::Vector3d workspace_min;      //!< [m] box in base_link that targets of the flange lie in
  Eigen::Vector3d workspace_max;      //!< [m]
  double most_linear_speed = 1.5;     //!< [m/s]
  double most_camera_rate = 10000.0;  //!< [Hz]
};

// Each throws scan_cell_common::Refused, naming what is wrong.

/// Finite, a rotation, and within the box.
void check_flange(const Eigen::Isometry3d& flange, const RobotLimits& limits);
/// Within the box.
void check_workspace(const Eigen::Isometry3d& flange, const RobotLimits& limits);
/// Six, finite, each within its range.
Joints check_joints(const std::vector<double>& joints, const RobotLimits& limits);
void check_camera_rate(double rate, const RobotLimits& limits);
void check_linear_speed(double speed, const RobotLimits& limits);
/// The speed that is set on the controller, by whomever.
void check_speed_in_force(double speed, const RobotLimits& limits);
void check_override(double percent);

}  // namespace c4g_driver
