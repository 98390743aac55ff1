// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace scan_cell_sim {

/// Why the controller refuses a request; the codes of c4g_protocol.md.
enum class ControllerErrorCode {
  Malformed = 1,
  Version = 2,
  Session = 3,
  Busy = 4,
  Straggler = 5,
  UnknownCommand = 6,
  UnknownParameter = 7,
  ReadOnly = 8,
  OutOfRange = 9,
  Moving = 10,
  EmergencyStop = 11,
  JointLimit = 12,
  OutOfReach = 13,
  Singular = 14,
  MotionFailed = 15,
  Mode = 16,
  Alarm = 17,
  OutOfTurn = 18,
};

/// What the controller complains of: why a motion did not arrive, or an alarm.
struct Complaint {
  ControllerErrorCode code;
  std::string text;
};

class ControllerRefusal : public std::runtime_error {
 public:
  ControllerRefusal(ControllerErrorCode code, const std::string& text)
      : std::runtime_error(text), code_(code) {}
  ControllerErrorCode code() const { return code_; }

 private:
  ControllerErrorCode code_;
};

}  // namespace scan_cell_sim
