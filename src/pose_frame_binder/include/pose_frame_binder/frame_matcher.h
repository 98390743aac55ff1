// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "pose_frame_binder/pulse_log.h"
#include "pose_frame_binder/types.h"

namespace pose_frame_binder {

/// Finds the pulse that exposed each frame.
///
/// Within one acquisition and one arming, count = counter - offset. A frame agrees where the pulse
/// that its counter gives is the one that its stamp gives (stamp - latency, see PulseLog::locate).
///
/// The offset is elected: frames are held until `frames_to_agree` of them vote for the same one.
/// From the first frame that does not agree there is doubt: it and those that follow are held, and
/// vote again. Where the old offset is elected, only those that do not agree with it are dropped.
/// Where another is, the counter has slipped: `frames_to_agree` - 1 frames on either side of the
/// slip are dropped as well, since a wrong stamp could have made them fit. So a frame is only told
/// once that many have followed that agree. The same holds where the camera was started again, and
/// where the counter does not go on from one arming to the next.
/// The latency follows the frames that agree.
class FrameMatcher {
 public:
  FrameMatcher(const PulseLog& pulses, const Settings& settings);

  /// What was found for one frame: its pulse, or why it is dropped.
  struct Result {
    std::size_t frame = 0;
    std::optional<std::size_t> pulse;  //!< index in the log; may be known for a dropped frame too
    std::optional<Drop> drop;
  };

  void add(std::size_t number, const Frame& frame);

  /// Goes as far as the pulses that are known allow; all the way once the pulses have ended.
  /// @return results in the order of the frames
  std::vector<Result> advance();

  /// No more frames will come.
  std::vector<Result> finish();

  std::size_t waiting() const { return queue_.size() + held_.size() + unconfirmed_.size(); }
  double latency() const;  //!< [s] measured; NaN before the first frame agreed
  std::uint64_t slips() const { return slips_; }

 private:
  struct Entry {
    std::size_t number;
    Frame frame;
  };
  struct Offset {
    std::uint32_t run = 0;
    std::int64_t value = 0;
    bool operator<(const Offset& other) const {
      return run != other.run ? run < other.run : value < other.value;
    }
    bool operator!=(const Offset& other) const { return run != other.run || value != other.value; }
  };
  /// A frame that agreed, until enough others follow.
  struct Unconfirmed {
    std::size_t number;
    std::uint64_t counter;
    std::size_t pulse;
  };
  struct Votes {
    std::vector<Nanoseconds> distances;  // from the pulse to the stamp less the latency
    std::uint64_t last_counter = 0;
    std::int64_t first_count = 0;
  };

  void take(const Entry& entry);
  void begin_acquisition(std::uint32_t acquisition);
  bool agrees(const Frame& frame) const;
  bool is_behind(const Frame& frame) const;
  void vote(const Frame& frame);
  void elect(const Offset& offset, Votes votes);
  Offset follow(const Offset& next) const;
  void elect_from_few();
  void flush();
  void judge(const Entry& entry);
  void accept(const Entry& entry);
  void release(std::size_t count);
  void drop_unconfirmed(const std::string& detail);
  void refuse(const Entry& entry);
  void drop(const Entry& entry, DropReason reason, const std::string& detail);
  bool take_out_of_gap(std::uint64_t counter);
  std::optional<std::size_t> pulse_of(const Frame& frame) const;
  PulseLog::Place locate(const Frame& frame) const;

  const PulseLog& pulses_;
  const Settings settings_;
  const std::size_t margin_;  // frames that must agree after one before it is told
  const Nanoseconds tolerance_;
  Nanoseconds latency_;
  bool latency_measured_ = false;
  std::uint64_t slips_ = 0;

  std::deque<Entry> queue_;  // waiting for pulses
  std::vector<Entry> held_;  // waiting for frames that agree
  std::vector<Result> results_;
  std::map<Offset, Votes> votes_;

  std::uint32_t acquisition_ = 0;
  std::optional<Offset> offset_;
  std::size_t drop_next_ = 0;                  // frames after a slip or a restart
  bool disputed_ = false;                      // the frames being judged voted for several offsets
  bool doubted_ = false;                       // a frame after the last that agreed does not
  std::optional<std::uint64_t> last_counter_;  // of the frames that agreed
  std::optional<std::size_t> last_pulse_;
  std::deque<Unconfirmed> unconfirmed_;
  std::map<std::uint64_t, std::uint64_t> gaps_;  // counters left out so far: first -> last
};

}  // namespace pose_frame_binder
