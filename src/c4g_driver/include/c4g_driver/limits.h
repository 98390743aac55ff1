// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "c4g_driver/robot_model.h"
#include "c4g_driver/robot_state.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace c4g_driver {

/// Who may be near the robot: in manual operation people may, so the flange moves slowly.
enum class Operation { kManual, kAutomatic };

/// Limits of what may be asked of the robot, in addition to those of its model.
struct RobotLimits {
  Operation operation = Operation::kManual;  //!< who may be near the robot
  Joints joint_lower = Joints::Constant(-std::numeric_limits<double>::infinity());  //!< [rad]
  Joints joint_upper = Joints::Constant(std::numeric_limits<double>::infinity());   //!< [rad]
  /// [m] box in base_link in which the flange stays; keeps the bracket clear of the floor
  Eigen::Vector3d workspace_min{-1.4, -1.4, 0.15};
  Eigen::Vector3d workspace_max{1.4, 1.4, 1.9};  //!< [m]
  double max_linear_speed = 1.5;                 //!< [m/s] along lines in automatic operation
  double max_camera_rate = 10000.0;              //!< [Hz]
};

/// Adds each parameter with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, RobotLimits& limits);

/// The same limits with the joint ranges narrowed to those of the robot.
/// @throw scan_cell_common::InvalidParameter if a joint has no range left, or the box is empty
RobotLimits narrowed(const RobotLimits& limits, const RobotModel& robot);

/// How fast the flange may move now.
struct SpeedLimit {
  double most = 0;       //!< [m/s]
  bool reduced = false;  //!< for people near the robot: applies to every motion, not only lines
  std::string reason;    //!< for a person
};

/// max_linear_speed, and at most 250 mm/s (ISO 10218-1, reduced speed) unless operation is
/// automatic and the controller is not in mode programming.
/// @param state the controller's latest state, if there is one
SpeedLimit speed_limit(const RobotLimits& limits, const RobotState* state);

// Each throws scan_cell_common::Refused, naming what is wrong.

/// The pose must be finite, a rotation, and within the box.
/// @param name of the pose
void check_flange(const Eigen::Isometry3d& flange, const RobotLimits& limits,
                  const std::string& name = "target");
/// The position must be within the box.
/// @param name of the pose
void check_workspace(const Eigen::Isometry3d& flange, const RobotLimits& limits,
                     const std::string& name = "target");
/// The joints must be six, finite, and each within its range.
Joints check_joints(const std::vector<double>& joints, const RobotLimits& limits);
/// @throw scan_cell_common::Refused if the rate [Hz] is out of range
void check_camera_rate(double rate, const RobotLimits& limits);
/// @throw scan_cell_common::Refused if the speed [m/s] is above the limit
void check_linear_speed(double speed, const SpeedLimit& limit);
/// Checks the speed set on the controller, whoever set it.
void check_speed_in_force(double speed, const SpeedLimit& limit);
/// @param most [%] the most that the motion in progress allows
void check_override(double percent, double most = 100);

}  // namespace c4g_driver
