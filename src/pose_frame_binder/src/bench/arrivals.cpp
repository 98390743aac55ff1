// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "arrivals.h"

#include <fmt/format.h>

#include <algorithm>

#include "scan_cell_common/errors/errors.h"

namespace pose_frame_binder {

bool Arrivals::wait(std::uint64_t count) const {
  constexpr double kPatience = 2;  // [s] chosen
  std::uint64_t before = count_;
  ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (count_ < count && ros::WallTime::now() < deadline) {
    ros::WallDuration(0.01).sleep();
    if (count_ == before) continue;
    before = count_;
    deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
  }
  return count_ >= count;
}

Latency latency_of(const std::vector<Instant>& sent, const std::vector<Arrivals::Arrival>& arrivals,
                   std::uint64_t per_profile) {
  std::vector<double> latencies;
  auto arrival = arrivals.begin();
  for (std::size_t i = 0; i < sent.size(); ++i) {
    while (arrival != arrivals.end() && arrival->count < (i + 1) * per_profile)
      ++arrival;
    if (arrival == arrivals.end()) {
      throw scan_cell_common::Refused(
          "the running chain", fmt::format("only {} of {} profiles came out", i, sent.size()),
          "check whether the machine is too busy");
    }
    latencies.push_back(std::chrono::duration<double>(arrival->time - sent[i]).count());
  }
  Latency latency;
  latency.last = latencies.back();
  std::sort(latencies.begin(), latencies.end());
  latency.median = latencies[latencies.size() / 2];
  latency.p99 = latencies[latencies.size() * 99 / 100];
  latency.worst = latencies.back();
  return latency;
}

}  // namespace pose_frame_binder
