// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "scan_cell_common/clock/clock_map.h"
#include "tecnogamma_camera/camera.h"

namespace tecnogamma_camera {

/// How device times become host times.
struct ClockSettings {
  double window = 10.0;         //!< [s] over which the least delay of the stream is sought
  bool device_is_host = false;  //!< the camera's clock is synchronised to the host's (PTP)
};

/// The place of a frame in the sequence of frames.
struct FramePlace {
  CounterStep step;          //!< how its counter follows
  bool restarted = false;    //!< the counter restarted with this frame: begin() was called
  bool was_garbled = false;  //!< this frame shows that the number after the last gap was wrong
  std::uint64_t found = 0;   //!< frames counted as lost in that gap but not lost
  Nanoseconds time = 0;      //!< [ns] of the exposure on the host's clock; 0 for INVALID
};

/// Numbers the frames of one camera and maps their times to the host's clock.
///
/// One wrong number is neither a restart nor a gap. A frame that counts back is late. If its clock
/// went on and the next frame continues from it (without a clock: the next two frames), the camera
/// was restarted. But if those frames continue the frames before the last gap, the number after
/// that gap was garbled; one frame whose clock went on is enough to know. The garbled frame itself
/// was delivered with its wrong number, which disagrees with its time.
class FrameNumbering {
 public:
  /// @param counter values that the device's frame counter runs through
  FrameNumbering(const CounterRule& counter, const ClockSettings& clock);

  /// The next frame is the first again.
  void begin();

  /// @throw scan_cell_common::UnusableInput if the clocks should agree and do not
  FramePlace place(const Frame& frame);

 private:
  /// A step forward over frames that did not come, until the next frame confirms it.
  struct Leap {
    CounterUnwrapper before;  // the counter before it, from which frames that count back continue
    std::uint64_t lost;       // frames counted as lost, minus those lost in any case
    Nanoseconds device_time;  // before it
  };

  void count_back(const Frame& frame, FramePlace& place);
  void take_back(const CounterStep& step, FramePlace& place);
  int counts_on_from_before(const Frame& frame);
  Nanoseconds time_of(const Frame& frame, bool late);

  ClockSettings settings_;
  CounterUnwrapper unwrapper_;
  std::optional<Leap> leap_;
  scan_cell_common::ClockMap clock_;
  bool clock_agreed_ = false;  // a frame came within a second of what the camera's clock says
  int late_in_a_row_ = 0;
  Nanoseconds last_device_time_ = 0;
  int counted_back_ = 0;         // frames in a row, each numbered after the one before
  std::uint64_t last_back_ = 0;  // the number of the last of them
};

}  // namespace tecnogamma_camera
