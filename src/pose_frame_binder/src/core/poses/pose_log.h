// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "pose_frame_binder/types.h"

namespace pose_frame_binder {

/// All poses of a scan, sorted by time. Settled poses no longer change, so decisions based on them
/// do not depend on later poses.
class PoseLog {
 public:
  /// @param settle how far a pose may arrive behind a later one [ns]
  PoseLog(Nanoseconds settle, std::size_t max_poses);

  /// Adds a pose. One that is not finite, arrives too late, or has the time of another one is
  /// dropped and counted.
  /// @throw scan_cell_common::Refused if the log is full
  void add(const TimedPose& pose);

  /// Call when no more poses will arrive: all are settled then.
  void end() { ended_ = true; }
  bool ended() const { return ended_; }

  /// Whether no pose at or before `time` can still arrive.
  bool settled(Nanoseconds time) const;

  /// Index of the first pose at or after `time`; size() if there is none.
  std::size_t first_at_or_after(Nanoseconds time) const;

  std::size_t size() const { return poses_.size(); }
  const TimedPose& operator[](std::size_t index) const { return poses_[index]; }

  std::uint64_t repeated() const { return repeated_; }
  std::uint64_t late() const { return late_; }
  std::uint64_t unusable() const { return unusable_; }

 private:
  Nanoseconds settle_;
  std::size_t max_;
  bool ended_ = false;
  std::deque<TimedPose> poses_;  // a vector would pause to copy everything when it grows
  std::uint64_t repeated_ = 0;
  std::uint64_t late_ = 0;
  std::uint64_t unusable_ = 0;
};

}  // namespace pose_frame_binder
