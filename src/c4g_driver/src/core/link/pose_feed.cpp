// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/pose_feed.h"

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
    ++dropped_.overtaken;
    return Verdict::kOvertaken;
  }
  newest_ = robot.controller_time;
  clock_.add(robot.controller_time, arrival);
  latest_ = {clock_.to_host(robot.controller_time), arrival, robot};
  const bool was_moving = moving_;
  moving_ = robot.status == MotionStatus::kMoving;
  // A better estimate of the network delay may put this pose before one already delivered. So does
  // a host clock that was set back, and for longer.
  if (latest_->time <= handed_on_) {
    ++dropped_.backward;
    return Verdict::kBackward;
  }
  handed_on_ = latest_->time;
  const bool counts = source == Source::kStream || !was_moving || !moving_;
  if (counts && arrival - latest_->time < timeout_) fresh_at_ = now;
  return Verdict::kHandOn;
}

bool PoseFeed::stale(Clock::time_point now) const {
  return now - fresh_at_ > std::chrono::nanoseconds(timeout_);
}

}  // namespace c4g_driver
