// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pose_frame_binder/types.h"
#include "tecnogamma_camera/counter_unwrapper.h"

namespace pose_frame_binder {

/// A frame as the binder receives it, and the truth about it.
struct FaultyFrame {
  Frame frame;
  Nanoseconds arrival = 0;
  std::int64_t pulse = -1;  //!< index of the pulse that exposed it; -1: none
};

struct FaultyPulse {
  Pulse pulse;
  Nanoseconds arrival = 0;
  bool lost = false;  //!< its event never arrives
};

/// The flange moves along x at 1 m/s: the x of a pose is the time at which it was measured.
struct FaultyPose {
  Nanoseconds time = 0;
  Nanoseconds arrival = 0;
  bool finite = true;
};

/// Faults as shares of the frames, pulses or poses; chosen.
struct FaultShares {
  double frame_lost = 0.06;
  double burst_lost = 0.0002;  //!< 50 frames in a row
  double repeated = 0.045;
  double out_of_order = 0.02;  //!< up to three frames too early; those in between arrive late
  double corrupt = 0.05;
  double garbled_counter = 0.02;   //!< of the corrupt frames
  double pulse_not_taken = 0.004;  //!< the camera's counter continues without a gap
  double frame_invented = 0.001;   //!< a frame without a pulse, which the counter counts
  double wrong_counter = 0.003;
  double wrong_stamp = 0.006;   //!< by up to 50 ms
  double restart = 0.0005;      //!< of the camera; half are reported, half show in the counter
  double pulse_missed = 0.002;  //!< the trigger leaves out a pulse
  double event_lost = 0.0005;
  double pose_lost = 0.05;
  double pose_gap = 0.0002;  //!< 80 ms without poses
  double pose_late = 0.03;   //!< by up to 60 ms
  double pose_unusable = 0.001;
};

/// Everything that trigger, camera and robot send, each in order of arrival, and the truth about
/// it. Every 20000 pulses the trigger is armed again, at 50, 100, 200 or 485 Hz.
struct FaultyScan {
  std::vector<FaultyPulse> pulses;  //!< all that were sent, in time order
  std::vector<FaultyFrame> frames;
  std::vector<FaultyPose> poses;
  std::vector<bool> faulty;  //!< by pulse: its frame has a fault
  std::size_t turns = 0;     //!< of the camera's counter

  /// @param rule of the camera's counter, unwrapped as by the camera's acquisition
  /// @param alternate the lasers take turns, and the first pulses of each arming are twice as far
  /// apart, as the trigger sends them; false: laser_0 alone
  FaultyScan(std::size_t pulse_count, const tecnogamma_camera::CounterRule& rule,
             const FaultShares& shares, unsigned seed, bool alternate);
};

constexpr Nanoseconds kScanStart = 1'700'000'000'000'000'000;  //!< [ns] in 2023; chosen

}  // namespace pose_frame_binder
