// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <boost/container/static_vector.hpp>
#include <boost/static_string/static_string.hpp>
#include <cstdint>
#include <optional>

#include "scan_cell_common/pose/timed_pose.h"

namespace c4g_driver {

/// Angles of the six axes [rad], Comau signs, in the order J1 .. J6.
using Joints = Eigen::Matrix<double, 6, 1>;

/// Status of the latest motion.
enum class MotionStatus { kIdle, kMoving, kArrived, kStopped, kError };

/// Position of the mode selector; c4g_protocol.md says what each mode allows.
enum class ControllerMode { kProgramming, kAutomatic, kRemote };

/// The word for it in the protocol.
const char* name_of(MotionStatus status);
const char* name_of(ControllerMode mode);  //!< the word for it in the protocol

/// An error that the controller reports.
struct ControllerError {
  int code = 0;                   //!< see c4g_protocol.md
  boost::static_string<80> text;  //!< printable ASCII
};

/// Errors that stay until they are reset. States arrive hundreds of times a second, so no part of
/// them allocates memory.
using Alarms = boost::container::static_vector<ControllerError, 4>;

/// State of the robot at one instant, as the controller reports it.
struct RobotState {
  scan_cell_common::Nanoseconds controller_time = 0;  //!< of the measurement, controller's clock
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();  //!< tool0 in base_link, measured
  Joints joints = Joints::Zero();                            //!< [rad] measured
  MotionStatus status = MotionStatus::kIdle;                 //!< of the latest motion
  std::uint64_t motion = 0;    //!< number of the request that the status refers to; 0: none
  double progress = 0;         //!< 0 .. 1
  std::uint64_t waypoint = 0;  //!< of a tool path, the one passed or reached last
  std::uint32_t outputs = 0;   //!< bit n: digital output n + 1 is on
  double camera_rate = 0;      //!< [Hz]
  bool e_stop = false;         //!< pressed
  bool drives = false;         //!< on
  ControllerMode mode = ControllerMode::kProgramming;  //!< position of the selector
  double override = 0;                                 //!< [%] above 0, up to 100
  double linear_speed = 0;                             //!< [m/s] above 0
  std::optional<ControllerError> error;                //!< why the latest motion did not arrive
  Alarms alarms;                                       //!< not yet reset
};

/// Whether the controller would begin a motion requested by this client.
inline bool takes_motions(const RobotState& robot) {
  return robot.drives && !robot.e_stop && robot.alarms.empty() &&
         robot.mode != ControllerMode::kAutomatic;
}

/// A state and its time on the host's clock.
struct MeasuredState {
  scan_cell_common::Nanoseconds time = 0;     //!< of the measurement, host clock
  scan_cell_common::Nanoseconds arrival = 0;  //!< when the kernel received the datagram
  RobotState robot;                           //!< as the controller sent it
};

}  // namespace c4g_driver
