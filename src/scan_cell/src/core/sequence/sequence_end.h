// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {

/// How a sequence ended; the values that the results of the cell's actions share. Theirs is 0 where
/// none began.
enum class Outcome : std::uint8_t {
  kFinished = 1,
  kRefused = 2,
  kCancelled = 3,
  kRobotLost = 4,
  kCameraLost = 5,
  kTriggerLost = 6,
  kMotionFailed = 7,
  kStageFailed = 8,  //!< what the data goes to: binder and triangulation, or the session's folder
  kPassesDisagree = 9,  //!< of a scan
};

struct SequenceEnd {
  Outcome outcome = Outcome::kFinished;
  std::string message;
};

/// Asked again and again while a sequence runs, by its thread: why it is to end early; empty: it
/// goes on.
using WhyToCancel = std::function<std::string()>;

/// Ends a sequence early, from any depth of it.
struct EndEarly {
  Outcome outcome;
  std::string message;
};

/// Carries out what belongs to one device; an error of it ends the sequence with that device's
/// outcome.
template <class Call>
auto on(Outcome outcome, const Call& call) {
  try {
    return call();
  } catch (const scan_cell_common::Error& error) {
    throw EndEarly{outcome, error.what()};
  }
}

/// The same, and tells a device that refuses from one that is lost.
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

/// Carries out what the robot is asked for: where it refuses no motion comes, and any other error
/// loses it.
template <class Call>
auto on_robot(const Call& call) {
  return on(Outcome::kMotionFailed, Outcome::kRobotLost, call);
}

/// Adds what went wrong besides, or after all was well.
inline void worsen(SequenceEnd& end, Outcome outcome, const std::string& why) {
  if (end.outcome == Outcome::kFinished) {
    end = {outcome, why};
  } else {
    end.message += "; besides: " + why;
  }
}

}  // namespace scan_cell
