// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "poses/pose_log.h"

#include <fmt/format.h>

#include <algorithm>

#include "scan_cell_common/errors/errors.h"

namespace pose_frame_binder {

PoseLog::PoseLog(Nanoseconds settle, std::size_t max_poses) : settle_(settle), max_(max_poses) {}

void PoseLog::add(const TimedPose& pose) {
  if (!pose.pose.matrix().allFinite()) {
    ++unusable_;
    return;
  }
  if (ended_ || (!poses_.empty() && pose.time <= poses_.back().time - settle_)) {
    ++late_;
    return;
  }
  const std::size_t place = first_at_or_after(pose.time);
  if (place < poses_.size() && poses_[place].time == pose.time) {
    ++repeated_;
    return;
  }
  if (poses_.size() >= max_) {
    throw scan_cell_common::Refused("pose log", fmt::format("full with {} poses", max_),
                                    "raise max_poses, or make the scan shorter");
  }
  poses_.insert(poses_.begin() + static_cast<std::ptrdiff_t>(place), pose);
}

bool PoseLog::settled(Nanoseconds time) const {
  return ended_ || (!poses_.empty() && time <= poses_.back().time - settle_);
}

std::size_t PoseLog::first_at_or_after(Nanoseconds time) const {
  const auto before = [](const TimedPose& pose, Nanoseconds t) { return pose.time < t; };
  const auto found = std::lower_bound(poses_.begin(), poses_.end(), time, before);
  return static_cast<std::size_t>(found - poses_.begin());
}

}  // namespace pose_frame_binder
