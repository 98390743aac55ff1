// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/frame_numbering.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace tecnogamma_camera {

using Kind = CounterStep::Kind;

FrameNumbering::FrameNumbering(const CounterRule& counter, const ClockSettings& clock)
    : settings_(clock), unwrapper_(counter), clock_(scan_cell_common::from_seconds(clock.window)) {}

void FrameNumbering::begin() {
  unwrapper_.reset();
  last_device_time_ = 0;
  counted_back_ = 0;
}

FramePlace FrameNumbering::place(const Frame& frame) {
  FramePlace place;
  place.step = unwrapper_.unwrap(frame.counter);
  if (place.step.kind == Kind::BACKWARD &&
      (counts_on_from_before(frame) || frame.device_time > last_device_time_)) {
    begin();
    place.restarted = true;
    place.step = unwrapper_.unwrap(frame.counter);
  }
  if (place.step.kind == Kind::INVALID) return place;
  if (place.step.kind == Kind::NEXT || place.step.kind == Kind::GAP) counted_back_ = 0;
  last_device_time_ = std::max(last_device_time_, frame.device_time);
  place.time = time_of(frame, place.step.kind == Kind::BACKWARD);
  return place;
}

bool FrameNumbering::counts_on_from_before(const Frame& frame) {
  constexpr int kInARow = 3;
  const bool goes_on = counted_back_ > 0 && frame.counter == last_back_ + 1;
  counted_back_ = goes_on ? counted_back_ + 1 : 1;
  last_back_ = frame.counter;
  return counted_back_ == kInARow;
}

Nanoseconds FrameNumbering::time_of(const Frame& frame, bool late) {
  if (frame.time != 0) return frame.time;
  if (frame.device_time == 0) return frame.host_time;  // no clock, or lost with its packets
  if (!settings_.device_is_host) {
    // The map would take an earlier time for that of a device that was restarted.
    if (!late || clock_.empty()) clock_.add(frame.device_time, frame.host_time);
    return clock_.to_host(frame.device_time);
  }
  constexpr double kMost = 1;      // [s]
  constexpr int kMostLate = 1000;  // frames: a host that was busy for a while has caught up by then
  const double off = scan_cell_common::to_seconds(frame.host_time - frame.device_time);
  late_in_a_row_ = off > kMost ? late_in_a_row_ + 1 : 0;
  clock_agreed_ = clock_agreed_ || std::abs(off) <= kMost;
  if (off < -kMost || late_in_a_row_ > (clock_agreed_ ? kMostLate : 0)) {
    throw scan_cell_common::UnusableInput(
        "device_clock", "the camera's clock is " + std::to_string(off) + " s off the host's",
        "synchronise it (PTP), or let its clock be mapped");
  }
  return frame.device_time;
}

}  // namespace tecnogamma_camera
