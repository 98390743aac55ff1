// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <optional>

#include "c4g_driver/link_report.h"
#include "c4g_driver/robot_state.h"

namespace c4g_driver {

/// Maps the controller's states to the host's clock, selects those to deliver, each once and in
/// time order, and detects when poses have become stale.
///
/// A pose is fresh if it is delivered and reached the host within the timeout of its instant. While
/// the robot moves, only the stream's poses count: those of acknowledgements are too far apart to
/// tell where it was.
class PoseFeed {
 public:
  using Clock = std::chrono::steady_clock;
  using Nanoseconds = scan_cell_common::Nanoseconds;
  enum class Source { kStream, kAcknowledgement };
  enum class Verdict {
    kHandOn,
    kOvertaken,  //!< measured no later than a state that arrived before
    kBackward    //!< measured later, but its host time is not later: the clock map changed
  };

  /// @param clock_window [s] over which the least network delay is taken
  /// @param timeout [s]
  PoseFeed(double clock_window, double timeout);

  /// A session begins: neither the controller's clock nor the host's need continue from before.
  void restart(Clock::time_point now);

  /// @param arrival on the host's clock
  Verdict take(const RobotState& robot, Nanoseconds arrival, Source source, Clock::time_point now);

  /// The latest state by the controller's clock, whether delivered or not, of any age.
  const std::optional<MeasuredState>& latest() const { return latest_; }

  /// True if the timeout has passed since the latest fresh pose or the restart.
  bool stale(Clock::time_point now) const;

  scan_cell_common::ClockMap::Figures clock() const { return clock_.figures(); }
  const DroppedPoses& dropped() const { return dropped_; }

 private:
  const Nanoseconds clock_window_;
  const Nanoseconds timeout_;
  scan_cell_common::ClockMap clock_;
  std::optional<MeasuredState> latest_;
  Nanoseconds newest_;     // controller's time of the latest state of this session
  Nanoseconds handed_on_;  // host time of the latest state delivered in this session
  bool moving_ = false;
  Clock::time_point fresh_at_;
  DroppedPoses dropped_;
};

}  // namespace c4g_driver
