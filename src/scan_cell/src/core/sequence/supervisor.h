// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "sequence/devices.h"
#include "sequence/sequence_end.h"

namespace scan_cell {

/// Time [s] on a clock that never goes back.
double monotonic_now();

/// Moves the robot and arms the trigger under supervision. All waiting is done here, while every
/// device is checked, a cancel is noticed and the trigger gets its keep-alive. All methods but
/// begin(), disarm() and stop_robot() throw EndEarly.
class Supervisor {
 public:
  struct Timing {
    double poll = 0.005;      //!< [s] between two checks of the devices
    double keep_alive = 0.1;  //!< [s] between two signs of life to the trigger
    double readiness = 1.0;   //!< [s] to hear from the robot before anything moves
    double stall = 5.0;       //!< [s] without progress after which a motion has failed
  };

  /// Another device to watch, and the outcome of a sequence if it fails.
  struct Watched {
    const Device* device;
    Outcome outcome;
  };

  /// @param others watched besides robot and trigger
  Supervisor(Robot& robot, Trigger& trigger, std::vector<Watched> others, const Timing& timing);

  /// Begins a new sequence, with nothing moving and nothing armed.
  void begin(WhyToCancel why_to_cancel);

  void wait_until_well();
  void start_move(const MoveTarget& target, double camera_rate);
  void wait_until_moving();

  /// Starts a motion of another kind, also reported by robot.motion().
  void start_other(const std::function<void()>& start);

  /// @param on_progress called with 0 .. 1
  void wait_for_motion(const std::function<void(double)>& on_progress);

  void arm(double rate, const Lighting& lighting);

  /// Stops the pulses and switches the lasers off; does nothing if arm() was not called.
  Disarmed disarm() noexcept;

  /// Stops a motion in progress.
  void stop_robot() noexcept;

  void watch();
  void sleep_and_watch();

  /// @return whether the condition became true within this time [s]
  bool wait_for(double time, const std::function<bool()>& condition);

 private:
  static void end_if_failed(const Motion& motion);
  void end_if_stalled(double deadline) const;
  void end_if_unseen();

  Robot& robot_;
  Trigger& trigger_;
  std::vector<Watched> watched_;
  Timing timing_;
  WhyToCancel why_to_cancel_;
  bool moving_ = false;
  bool armed_ = false;
  bool unseen_before_ = false;  // the robot, at the last check
  double last_keep_alive_ = 0;
};

}  // namespace scan_cell
