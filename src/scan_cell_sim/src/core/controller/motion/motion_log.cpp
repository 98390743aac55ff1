// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/motion/motion_log.h"

#include <algorithm>

namespace scan_cell_sim {

using scan_cell_common::Nanoseconds;
using scan_cell_common::to_seconds;

double Run::way(Nanoseconds host) const {
  return profile.position(to_seconds(host - start));
}

double Run::speed(Nanoseconds host) const {
  return profile.speed(to_seconds(host - start));
}

bool Run::over(Nanoseconds host) const {
  return to_seconds(host - start) >= profile.duration();
}

std::uint32_t Run::outputs(Nanoseconds host) const {
  return follows && !over(host) ? path->outputs(way(host)) : 0;
}

MotionLog::MotionLog(const Joints& start) {
  runs_.push_back({0, plan_joint_path(start, start).path, SpeedProfile::rest(1), false});
}

void MotionLog::begin(const Run& run) {
  constexpr std::size_t kMaxRuns = 10000;  // hours of motions; chosen
  const std::lock_guard<std::mutex> lock(mutex_);
  runs_.push_back(run);
  if (runs_.size() > kMaxRuns) runs_.pop_front();
}

Run MotionLog::at(Nanoseconds host) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto later =
      std::upper_bound(runs_.begin(), runs_.end(), host,
                       [](Nanoseconds instant, const Run& run) { return instant < run.start; });
  return later == runs_.begin() ? runs_.front() : *std::prev(later);
}

Run MotionLog::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return runs_.back();
}

}  // namespace scan_cell_sim
