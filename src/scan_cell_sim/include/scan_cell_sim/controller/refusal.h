// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace scan_cell_sim {

/// Why the controller refuses a request; the codes of c4g_protocol.md.
enum class ControllerErrorCode {
  kMalformed = 1,
  kVersion = 2,
  kSession = 3,
  kBusy = 4,
  kStraggler = 5,
  kUnknownCommand = 6,
  kUnknownParameter = 7,
  kReadOnly = 8,
  kOutOfRange = 9,
  kMoving = 10,
  kEmergencyStop = 11,
  kJointLimit = 12,
  kOutOfReach = 13,
  kSingular = 14,
  kMotionFailed = 15,
  kMode = 16,
  kAlarm = 17,
  kOutOfTurn = 18,
  kNoArc = 19,
  kNoPath = 20,
  kBadPath = 21,
  kNotAtStart = 22,
};

/// Why a motion did not arrive, or an alarm.
struct Complaint {
  ControllerErrorCode code;  //!< of c4g_protocol.md
  std::string text;          //!< for a person
};

/// A request that the controller refuses.
class ControllerRefusal : public std::runtime_error {
 public:
  /// @param text for a person
  ControllerRefusal(ControllerErrorCode code, const std::string& text)
      : std::runtime_error(text), code_(code) {}
  ControllerErrorCode code() const { return code_; }  //!< of c4g_protocol.md

 private:
  ControllerErrorCode code_;
};

}  // namespace scan_cell_sim
