// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scan_cell_common/timed_pose.h"

namespace c4g_driver {

/// Angles of the six axes [rad], Comau signs, in the order J1 .. J6.
using Joints = Eigen::Matrix<double, 6, 1>;

/// How the latest motion stands.
enum class MotionStatus { Idle, Moving, Arrived, Stopped, Error };

/// Where the mode selector stands; docs/c4g_protocol.md says what each mode allows.
enum class ControllerMode { Programming, Automatic, Remote };

/// What the controller complains of; codes in docs/c4g_protocol.md.
struct ControllerError {
  int code = 0;
  std::string text;
};

/// What the controller tells about the robot at one instant.
struct RobotState {
  scan_cell_common::Nanoseconds controller_time = 0;  //!< of the measurement, controller's clock
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();  //!< tool0 in base_link, measured
  Joints joints = Joints::Zero();                            //!< [rad] measured
  MotionStatus status = MotionStatus::Idle;
  std::uint64_t motion = 0;  //!< number of the MOVE request that the status is about, 0: none
  double progress = 0;       //!< 0 .. 1
  double camera_rate = 0;    //!< [Hz]
  bool e_stop = false;
  bool drives = false;
  ControllerMode mode = ControllerMode::Programming;
  double override = 0;                   //!< [%]
  double linear_speed = 0;               //!< [m/s]
  std::optional<ControllerError> error;  //!< why the latest motion did not arrive
  std::vector<ControllerError> alarms;   //!< that stand until they are reset
};

/// Whether the controller would begin a motion that this client asks for.
inline bool takes_motions(const RobotState& robot) {
  return robot.drives && !robot.e_stop && robot.alarms.empty() &&
         robot.mode != ControllerMode::Automatic;
}

/// A state, and its instant on the host's clock.
struct MeasuredState {
  scan_cell_common::Nanoseconds time = 0;
  RobotState robot;
};

}  // namespace c4g_driver
