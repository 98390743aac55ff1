// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pose_frame_binder/types.h"

namespace pose_frame_binder {

class FrameLog;
class FrameMatcher;
class PoseLog;
class PoseRule;
class PulseLog;
struct FrameRecord;

/// Binds the frames of one scan to the poses at their pulses.
///
/// Poses, pulses and frames may arrive in any order relative to each other: the decisions do not
/// depend on it. Not thread-safe.
class Binder {
 public:
  /// @throw scan_cell_common::InvalidParameter as check()
  explicit Binder(const Settings& settings);
  ~Binder();
  Binder(const Binder&) = delete;
  Binder& operator=(const Binder&) = delete;

  /// Announces the next arming of the trigger. Call it before each arming, or never: then each
  /// arming is a pass.
  /// @throw as check(run, settings)
  /// @throw scan_cell_common::Refused if it is not the first run and the settings give a motion
  void start_run(const Run& run);

  /// @throw scan_cell_common::Refused if the pose log is full
  void add_pose(const TimedPose& pose);
  /// Drops and counts a pulse that is repeated or out of order.
  /// @throw scan_cell_common::Refused, like add_pose() and add_frame(), if the method needs a
  /// motion that was not announced
  void add_pulse(const Pulse& pulse);

  /// @return the frame's number: 0, 1, ... in order of arrival
  /// @throw scan_cell_common::Refused if too many frames wait for pulses or poses
  std::size_t add_frame(const Frame& frame);

  /// Call when no more pulses will arrive.
  void end_pulses();

  /// Call when no more data will arrive: decides everything that is left.
  /// @param triggers number of pulses sent, if known: the audit says how many of them are missing
  void end(std::uint64_t triggers = 0);

  /// Returns the decisions since the last call. Matches are in the order of the frames.
  std::vector<Decision> take_decisions();

  /// Whether each of `triggers` pulses has arrived and is bound or named by a dropped frame.
  bool whole(std::uint64_t triggers) const;

  /// Grows with each pulse and with each frame that may belong to a pulse. Frames that no pulse
  /// exposed, as from a free-running camera, count only at first.
  std::uint64_t progress() const;

  std::uint64_t pulses() const;                     //!< known so far
  const PoseLog& poses() const { return *poses_; }  //!< measured so far

  /// Covers what has been decided; complete after end().
  Audit audit() const;

  /// The audit without what takes a pass over all frames and pulses: the list of drops, the frames
  /// that never arrived, and latency_doubtful. For the diagnostics of a running scan.
  Audit counts() const;

 private:
  enum class Fate : std::uint8_t { kUnknown, kDropped, kBound };

  void advance();
  void on_drop(const FrameRecord& frame, const std::string& detail);
  void bind();
  std::uint32_t pass_of(std::size_t pulse) const;
  void count(const Match& match);
  void settle(std::size_t pulse, Fate fate);
  bool latency_doubtful() const;

  const Settings settings_;
  const std::unique_ptr<PoseRule> rule_;
  const std::unique_ptr<PoseLog> poses_;
  const std::unique_ptr<PulseLog> pulses_;
  const std::unique_ptr<FrameLog> frames_;
  const std::unique_ptr<FrameMatcher> matcher_;
  std::vector<std::uint32_t> passes_;  // of the runs, as announced
  std::vector<Fate> fates_;            // of the pulses
  std::uint64_t settled_ = 0;          // pulses whose fate is known
  std::vector<Decision> decisions_;
  std::uint64_t triggers_ = 0;  // pulses sent, from end()
  Audit counts_;                // of the frames bound
  std::vector<Drop> dropped_;
};

}  // namespace pose_frame_binder
