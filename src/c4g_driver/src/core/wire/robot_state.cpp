// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/robot_state.h"

namespace c4g_driver {

const char* name_of(MotionStatus status) {
  switch (status) {
    case MotionStatus::kIdle:
      return "idle";
    case MotionStatus::kMoving:
      return "moving";
    case MotionStatus::kArrived:
      return "arrived";
    case MotionStatus::kStopped:
      return "stopped";
    case MotionStatus::kError:
      return "error";
  }
  return "";
}

const char* name_of(ControllerMode mode) {
  switch (mode) {
    case ControllerMode::kProgramming:
      return "programming";
    case ControllerMode::kAutomatic:
      return "automatic";
    case ControllerMode::kRemote:
      return "remote";
  }
  return "";
}

}  // namespace c4g_driver
