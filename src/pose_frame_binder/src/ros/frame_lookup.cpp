// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "frame_lookup.h"

#include <utility>

#include "scan_cell_common/ros/conversions.h"

namespace pose_frame_binder {

FrameLookup::FrameLookup(const LookupParameters& parameters) : on_(parameters.port > 0) {
  if (!on_) return;
  const auto answer = [this](std::string_view line) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return finished_.answer(line);
  };
  server_ = std::make_unique<LookupServer>(
      parameters.address, static_cast<std::uint16_t>(parameters.port), parameters.limits, answer);
}

void FrameLookup::start() {
  collected_ = {};
  const std::lock_guard<std::mutex> lock(mutex_);
  finished_ = {};
}

void FrameLookup::add(const scan_cell_msgs::BoundProfile& bound) {
  if (on_) collected_.add(bound.match.frame_counter, scan_cell_common::from_ros(bound.pose));
}

void FrameLookup::finish() {
  collected_.seal();
  const std::lock_guard<std::mutex> lock(mutex_);
  finished_ = std::exchange(collected_, {});
}

}  // namespace pose_frame_binder
