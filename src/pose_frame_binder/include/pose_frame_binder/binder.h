// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "pose_frame_binder/frame_matcher.h"
#include "pose_frame_binder/pose_log.h"
#include "pose_frame_binder/pose_rule.h"
#include "pose_frame_binder/pulse_log.h"
#include "pose_frame_binder/types.h"

namespace pose_frame_binder {

/// Binds the frames of one scan to the poses at their pulses.
///
/// Poses, pulses and frames may come in any order relative to each other: what is decided does not
/// depend on it. Not safe for use from several threads at once.
class Binder {
 public:
  /// @throw scan_cell_common::InvalidParameter as check()
  explicit Binder(const Settings& settings);
  Binder(const Binder&) = delete;
  Binder& operator=(const Binder&) = delete;

  /// @throw scan_cell_common::Refused if the pose log is full
  void add_pose(const TimedPose& pose);
  void add_pulse(const Pulse& pulse);

  /// @return its number: 0, 1, ... in the order of arrival
  /// @throw scan_cell_common::Refused if too many frames wait for pulses or poses
  std::size_t add_frame(const Frame& frame);

  /// No more pulses will come.
  void end_pulses();

  /// Nothing more will come: all that is left is decided.
  /// @param triggers pulses that were sent, where that is known: the audit says how many of them
  /// are missing
  void end(std::uint64_t triggers = 0);

  /// What was decided since the last call. Matches come in the order of the frames.
  std::vector<Decision> take_decisions();

  /// Whether every one of `triggers` pulses is there and bound or named by a dropped frame.
  bool whole(std::uint64_t triggers) const;

  /// Grows with each pulse and with each frame that may be of one; of frames that no pulse exposed,
  /// such as those of a camera in free run, only with the first few.
  std::uint64_t progress() const {
    return pulses_.size() + settled_ + pending_.size() + matcher_.waiting();
  }

  std::uint64_t pulses() const { return pulses_.size(); }
  const PoseLog& poses() const { return poses_; }

  /// Of what has been decided; complete after end().
  Audit audit() const;

  /// The same without what takes a walk through all frames and pulses: the list of drops, the
  /// frames that never arrived and latency_doubtful. For the diagnostics of a scan under way.
  Audit counts() const;

 private:
  enum class Fate : std::uint8_t { Unknown, Dropped, Bound };
  struct Pending {
    std::size_t frame;
    std::size_t pulse;
  };

  void advance();
  void take(const FrameMatcher::Result& result);
  void bind();
  void settle(std::size_t pulse, Fate fate);
  bool latency_doubtful() const;

  const Settings settings_;
  const std::unique_ptr<PoseRule> rule_;
  PoseLog poses_;
  PulseLog pulses_;
  FrameMatcher matcher_;
  std::vector<std::uint64_t> counters_;  // of the frames
  std::deque<Pending> pending_;          // with a pulse, waiting for poses
  std::vector<Fate> fates_;              // of the pulses
  std::uint64_t settled_ = 0;            // pulses whose fate is known
  std::vector<Decision> decisions_;
  std::uint64_t triggers_ = 0;  // pulses sent, as end() was told
  Audit counts_;                // of the frames bound
  std::vector<Drop> dropped_;
};

}  // namespace pose_frame_binder
