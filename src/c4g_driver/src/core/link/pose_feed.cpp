// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/pose_feed.h"

#include <limits>

namespace c4g_driver {

using scan_cell_common::from_seconds;

PoseFeed::PoseFeed(double clock_window, double timeout)
    : clock_window_(from_seconds(clock_window)),
      timeout_(from_seconds(timeout)),
      clock_(clock_window_) {
  restart(Clock::now());
}

void PoseFeed::restart(Clock::time_point now) {
  clock_ = scan_cell_common::ClockMap(clock_window_);
  newest_ = handed_on_ = std::numeric_limits<Nanoseconds>::min();
  moving_ = false;
  fresh_at_ = now;
}

PoseFeed::Verdict PoseFeed::take(const RobotState& robot, Nanoseconds arrival, Source source,
                                 Clock::time_point now) {
  if (robot.controller_time <= newest_) {
    ++counts_.overtaken;
    return Verdict::Overtaken;
  }
  newest_ = robot.controller_time;
  clock_.add(robot.controller_time, arrival);
  latest_ = {clock_.to_host(robot.controller_time), arrival, robot};
  const bool was_moving = moving_;
  moving_ = robot.status == MotionStatus::Moving;
  // A better estimate of the wire's delay may put it before one that was handed on already; so does
  // a host clock that was set back, and for longer.
  if (latest_->time <= handed_on_) {
    ++counts_.backward;
    return Verdict::Backward;
  }
  handed_on_ = latest_->time;
  const bool counts = source == Source::Stream || !was_moving || !moving_;
  if (counts && arrival - latest_->time < timeout_) fresh_at_ = now;
  return Verdict::HandOn;
}

bool PoseFeed::stale(Clock::time_point now) const {
  return now - fresh_at_ > std::chrono::nanoseconds(timeout_);
}

}  // namespace c4g_driver
