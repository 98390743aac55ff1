// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/robot_state.h"

namespace c4g_driver {

const char* name_of(MotionStatus status) {
  switch (status) {
    case MotionStatus::Idle:
      return "idle";
    case MotionStatus::Moving:
      return "moving";
    case MotionStatus::Arrived:
      return "arrived";
    case MotionStatus::Stopped:
      return "stopped";
    case MotionStatus::Error:
      return "error";
  }
  return "";
}

const char* name_of(ControllerMode mode) {
  switch (mode) {
    case ControllerMode::Programming:
      return "programming";
    case ControllerMode::Automatic:
      return "automatic";
    case ControllerMode::Remote:
      return "remote";
  }
  return "";
}

}  // namespace c4g_driver
