// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "acquisition/frame_numbering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace tecnogamma_camera {

using Kind = CounterStep::Kind;

FrameNumbering::FrameNumbering(const CounterRule& counter, const ClockSettings& clock)
    : settings_(clock), unwrapper_(counter), clock_(scan_cell_common::from_seconds(clock.window)) {}

void FrameNumbering::begin() {
  unwrapper_.reset();
  leap_.reset();
  last_device_time_ = 0;
  counted_back_ = 0;
}

FramePlace FrameNumbering::place(const Frame& frame) {
  FramePlace place;
  const CounterUnwrapper before = unwrapper_;
  place.step = unwrapper_.unwrap(frame.counter);
  if (place.step.kind == Kind::kBackward) count_back(frame, place);
  if (place.step.kind == Kind::kInvalid) return place;
  if (place.step.kind == Kind::kNext || place.step.kind == Kind::kGap) counted_back_ = 0;
  if (place.step.kind == Kind::kNext) leap_.reset();
  if (place.step.kind == Kind::kGap && !place.was_garbled)
    leap_ = Leap{before, place.step.lost, last_device_time_};
  last_device_time_ = std::max(last_device_time_, frame.device_time);
  place.time = time_of(frame, place.step.kind == Kind::kBackward);
  return place;
}

void FrameNumbering::count_back(const Frame& frame, FramePlace& place) {
  constexpr int kWithClock = 2, kWithout = 3;  // frames in a row; chosen
  const bool clock_went_on = last_device_time_ != 0 && frame.device_time > last_device_time_;
  const int in_a_row = counts_on_from_before(frame);
  if (leap_) {
    const bool late = frame.device_time > leap_->device_time && !clock_went_on;
    const CounterStep step = leap_->before.unwrap(frame.counter);
    if (step.kind == Kind::kNext || step.kind == Kind::kGap) {
      if (clock_went_on || (!late && in_a_row == kWithout)) return take_back(step, place);
      leap_->lost -= step.lost;
      return;
    }
  }
  if (in_a_row < (clock_went_on ? kWithClock : kWithout)) return;
  begin();
  place.restarted = true;
  place.step = unwrapper_.unwrap(frame.counter);
}

void FrameNumbering::take_back(const CounterStep& step, FramePlace& place) {
  place.step = step;
  place.was_garbled = true;
  place.found = leap_->lost;
  unwrapper_ = leap_->before;
  leap_.reset();
}

/// @return number of frames in a row that counted on like this, including this one
int FrameNumbering::counts_on_from_before(const Frame& frame) {
  const bool goes_on = counted_back_ > 0 && frame.counter == last_back_ + 1;
  counted_back_ = goes_on ? counted_back_ + 1 : 1;
  last_back_ = frame.counter;
  return counted_back_;
}

Nanoseconds FrameNumbering::time_of(const Frame& frame, bool late) {
  if (frame.time != 0) return frame.time;
  if (frame.device_time == 0) return frame.host_time;  // no clock, or lost with its packets
  if (!settings_.device_is_host) {
    // The map would read an earlier time as a restart of the device.
    if (!late || clock_.empty()) clock_.add(frame.device_time, frame.host_time);
    return clock_.to_host(frame.device_time);
  }
  constexpr double kMost = 1;      // [s] between clocks that are one; chosen
  constexpr double kMaxLate = 10;  // [s] of a frame on a busy host; chosen
  // Frames in a row; chosen: a busy host has caught up by then, and sooner with the first frames.
  constexpr int kMaxLateInARow = 1000, kMaxLateAtFirst = 20;
  const double off = scan_cell_common::to_seconds(frame.host_time - frame.device_time);
  late_in_a_row_ = off > kMost ? late_in_a_row_ + 1 : 0;
  clock_agreed_ = clock_agreed_ || std::abs(off) <= kMost;
  const bool is_another = off < -kMost || (!clock_agreed_ && off > kMaxLate);
  if (is_another || late_in_a_row_ > (clock_agreed_ ? kMaxLateInARow : kMaxLateAtFirst)) {
    throw scan_cell_common::UnusableInput(
        "device_clock", fmt::format("the camera's clock is {:.6g} s off the host's", off),
        "synchronise it (PTP), or set device_clock to mapped");
  }
  return frame.device_time;
}

}  // namespace tecnogamma_camera
