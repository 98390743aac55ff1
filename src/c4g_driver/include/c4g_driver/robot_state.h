// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "scan_cell_common/timed_pose.h"

namespace c4g_driver {

/// Angles of the six axes [rad], Comau signs, in the order J1 .. J6.
using Joints = Eigen::Matrix<double, 6, 1>;

/// How the latest motion stands.
enum class MotionStatus { Idle, Moving, Arrived, Stopped, Error };

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
  bool automatic = false;   //!< mode: automatic, or manual
  double override = 0;      //!< [%]
  double linear_speed = 0;  //!< [m/s]
  std::optional<ControllerError> error;
};

/// A state, and its instant on the host's clock.
struct MeasuredState {
  scan_cell_common::Nanoseconds time = 0;
  RobotState robot;
};

}  // namespace c4g_driver
