// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {

/// How a sequence ended; values shared by the results of the cell's actions, which use 0 if none
/// began.
enum class Outcome : std::uint8_t {
  kFinished = 1,
  kRefused = 2,
  kCancelled = 3,
  kRobotLost = 4,
  kCameraLost = 5,
  kTriggerLost = 6,
  kMotionFailed = 7,
  kStageFailed = 8,     //!< binder or triangulation, or the session's folder
  kPassesDisagree = 9,  //!< scans only
};

struct SequenceEnd {
  Outcome outcome = Outcome::kFinished;
  std::string message;
};

/// Called again and again by the sequence's thread while it runs: why to end early; empty: go on.
using WhyToCancel = std::function<std::string()>;

/// Thrown to end a sequence early, from any depth.
struct EndEarly {
  Outcome outcome;
  std::string message;
};

/// Runs a call to one device; an error ends the sequence with that device's outcome.
template <class Call>
auto on(Outcome outcome, const Call& call) {
  try {
    return call();
  } catch (const scan_cell_common::Error& error) {
    throw EndEarly{outcome, error.what()};
  }
}

/// The same, but distinguishes a device that refuses from one that is lost.
template <class Call>
auto on(Outcome refused, Outcome lost, const Call& call) {
  try {
    return call();
  } catch (const scan_cell_common::Refused& refusal) {
    throw EndEarly{refused, refusal.what()};
  } catch (const scan_cell_common::Error& error) {
    throw EndEarly{lost, error.what()};
  }
}

/// Runs a request to the robot: a refusal means that the motion failed, any other error that the
/// robot is lost.
template <class Call>
auto on_robot(const Call& call) {
  return on(Outcome::kMotionFailed, Outcome::kRobotLost, call);
}

/// Adds a further problem, or one that arose after all was well.
inline void worsen(SequenceEnd& end, Outcome outcome, const std::string& why) {
  if (end.outcome == Outcome::kFinished) {
    end = {outcome, why};
  } else {
    end.message += "; in addition: " + why;
  }
}

}  // namespace scan_cell
