// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frames/frame_log.h"
#include "matching/latency_proof.h"
#include "matching/pulse_log.h"
#include "pose_frame_binder/types.h"

namespace pose_frame_binder {

/// Finds the pulse that exposed each frame.
///
/// Within one acquisition and one arming, count = counter - offset. A frame agrees if its counter
/// and its stamp give the same pulse (stamp - latency, see PulseLog::locate).
///
/// The offset is elected: frames are held until `frames_to_agree` of them vote for the same one.
/// From the first frame that does not agree, frames are held and vote again. If the old offset
/// wins, only the frames that do not agree with it are dropped. If another one wins, the counter
/// has slipped: `frames_to_agree` - 1 frames on either side of the slip are dropped as well, since
/// a wrong stamp could have made them fit. So a frame is only released once that many frames that
/// agree have followed. The same applies if the camera was restarted, or if the counter does not
/// continue from one arming to the next. The latency follows the frames that agree.
///
/// With alternating lasers, a latency that is wrong by a pulse interval would give every frame the
/// wrong laser. Such frames wait until the latency is proved (LatencyProof), and are dropped if it
/// is not. It stays proved through slips and armings until the camera is restarted, since the
/// camera's clock continues.
class FrameMatcher {
 public:
  /// Moves the frames of `frames` from kArrived to kMatched or kDropped.
  FrameMatcher(const PulseLog& pulses, FrameLog& frames, const Settings& settings);

  /// Goes as far as the known pulses allow; all the way once the pulses have ended.
  void advance();

  /// Call when no more frames will arrive.
  void finish();

  double latency() const;  //!< [s] measured; NaN before the first frame has agreed
  std::uint64_t slips() const { return slips_; }

 private:
  struct Offset {
    std::uint32_t run = 0;
    std::int64_t value = 0;
    bool operator<(const Offset& other) const {
      return run != other.run ? run < other.run : value < other.value;
    }
    bool operator!=(const Offset& other) const { return run != other.run || value != other.value; }
  };
  struct Votes {
    std::vector<Nanoseconds> distances;  // from the pulse to the stamp minus the latency
    std::uint64_t last_counter = 0;
    std::int64_t first_count = 0;
  };

  void take(FrameRecord& record);
  void begin_acquisition(std::uint32_t acquisition);
  bool agrees(const Frame& frame) const;
  bool is_behind(const Frame& frame) const;
  void vote(const Frame& frame);
  void elect(const Offset& offset, Votes votes);
  Offset follow(const Offset& next) const;
  void elect_from_few();
  std::size_t usable_held() const;
  void judge_held(bool disputed);
  void judge(FrameRecord& record, bool disputed);
  void accept(FrameRecord& record);
  void confirm(std::size_t count);
  void confirm_all();
  void settle_unproved();
  void drop_unconfirmed(const std::string& detail);
  FrameRecord& first_agreed();
  FrameRecord& first_unproved();
  FrameRecord& first_in(FrameState state, std::size_t& first);
  bool last_judged_disagreed() const;
  void refuse(FrameRecord& record, bool disputed);
  void drop(FrameRecord& record, DropReason reason, const std::string& detail);
  bool take_out_of_gap(std::uint64_t counter);
  std::optional<std::size_t> pulse_of(const Frame& frame) const;
  Nanoseconds expected_latency() const { return latency_.value_or(initial_latency_); }
  PulseLog::Place locate(const Frame& frame) const;

  const PulseLog& pulses_;
  FrameLog& frames_;
  const Settings settings_;
  const std::size_t margin_;  // frames that must agree after a frame to confirm it
  const Nanoseconds tolerance_;
  const Nanoseconds initial_latency_;
  std::optional<Nanoseconds> latency_;  // measured, from the first election on
  LatencyProof proof_;
  std::uint64_t slips_ = 0;

  std::size_t next_ = 0;            // number of the first frame in kArrived
  std::size_t first_held_ = 0;      // of the first frame in kHeld, if there is one
  std::size_t first_agreed_ = 0;    // none before it is in kAgreed
  std::size_t first_unproved_ = 0;  // none before it is in kUnproved
  std::map<Offset, Votes> votes_;

  std::uint32_t acquisition_ = 0;
  std::optional<Offset> offset_;
  std::size_t drop_next_ = 0;                  // frames after a slip or a restart
  std::optional<std::uint64_t> last_counter_;  // of the frames that agreed
  std::optional<std::size_t> last_pulse_;
  std::map<std::uint64_t, std::uint64_t> gaps_;  // counters left out so far: first -> last
};

}  // namespace pose_frame_binder
