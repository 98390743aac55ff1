// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "pose_frame_binder/types.h"

namespace pose_frame_binder {

/// Progress of a frame, in the order in which frames pass through the states. A frame never
/// overtakes one that arrived before it, unless that one was dropped.
enum class FrameState : std::uint8_t {
  kArrived,   //!< waits for the pulses around its stamp
  kHeld,      //!< waits for frames that agree on the counter's offset
  kAgreed,    //!< has a pulse; waits for later frames that agree
  kUnproved,  //!< its pulse is settled unless the latency is wrong; waits for proof
  kMatched,   //!< its pulse is settled; waits for poses
  kBound,
  kDropped,
};

/// What the binder knows of one frame.
struct FrameRecord {
  std::size_t number = 0;  //!< 0, 1, ... in the order of arrival
  Frame frame;
  FrameState state = FrameState::kArrived;
  std::optional<std::size_t>
      pulse;  //!< index in the pulse log; may also be known for a dropped frame
  DropReason reason = DropReason::kNoTrigger;  //!< valid if the frame is dropped
};

/// The frames of a scan, from the first undecided one.
class FrameLog {
 public:
  /// Called with each frame that is dropped.
  using OnDrop = std::function<void(const FrameRecord& frame, const std::string& detail)>;

  explicit FrameLog(OnDrop on_drop) : on_drop_(std::move(on_drop)) {}

  /// @return the frame's number
  std::size_t add(const Frame& frame);

  FrameRecord& operator[](std::size_t number) { return records_[number - first_]; }

  std::size_t first() const { return first_; }  //!< number of the first frame held here
  std::size_t end() const { return first_ + records_.size(); }  //!< number of frames so far

  std::size_t count(FrameState state) const { return counts_[static_cast<std::size_t>(state)]; }

  /// Frames that are neither bound nor dropped.
  std::size_t undecided() const;

  void set(FrameRecord& frame, FrameState state);
  void drop(FrameRecord& frame, DropReason reason, const std::string& detail);

  /// Forgets the decided frames at the front and returns the first undecided one; null if none.
  FrameRecord* first_undecided();

 private:
  OnDrop on_drop_;
  std::deque<FrameRecord> records_;
  std::size_t first_ = 0;
  std::array<std::size_t, 7> counts_{};  // number of records by FrameState
};

}  // namespace pose_frame_binder
