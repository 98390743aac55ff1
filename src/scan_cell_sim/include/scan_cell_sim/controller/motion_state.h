// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "scan_cell_sim/controller/path.h"
#include "scan_cell_sim/controller/readiness.h"

namespace scan_cell_sim {

/// Status of the latest motion.
enum class MotionStatus { kIdle, kMoving, kArrived, kStopped, kError };

const char* name_of(MotionStatus status);  //!< as the protocol writes it

/// Settings that a client may change, as the parameters of c4g_protocol.md.
struct MotionSettings {
  bool in_joints = false;  //!< MOVE_CARTESIAN goes in joints
  LineSettings line;       //!< of motions along a line or an arc
  double override = 1;     //!< above 0, up to 1
};

/// The content of a state datagram, true values.
struct MotionState {
  MotionStatus status = MotionStatus::kIdle;  //!< of the latest motion
  std::uint64_t motion = 0;                   //!< number of the motion that the status is about
  double progress = 0;                        //!< 0 .. 1
  std::uint64_t waypoint = 0;                 //!< of a path of the tool, the last one passed
  std::uint32_t outputs = 0;                  //!< bit n: digital output n + 1 is on
  double camera_rate = 0;                     //!< [Hz]
  Readiness readiness;                        //!< mode, drives, emergency stop, alarms
  std::optional<Complaint> why;               //!< of Stopped and Error; none for a stop by request
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();  //!< tool0 in base_link [m]
  Joints joints = Joints::Zero();                            //!< [rad]
  MotionSettings settings;                                   //!< of the motions that follow
};

}  // namespace scan_cell_sim
