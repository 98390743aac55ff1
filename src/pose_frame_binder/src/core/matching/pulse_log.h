// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pose_frame_binder/types.h"

namespace pose_frame_binder {

/// All pulses of a scan, in time order.
class PulseLog {
 public:
  /// Adds a pulse. A repeated pulse, or one earlier than the last, is dropped and counted.
  void add(const Pulse& pulse);

  /// Call when no more pulses will arrive.
  void end() { ended_ = true; }
  bool ended() const { return ended_; }

  std::size_t size() const { return entries_.size(); }
  const Pulse& operator[](std::size_t index) const { return entries_[index].pulse; }

  /// The run of counts that the pulse belongs to: one arming of one trigger. A restarted trigger
  /// may repeat an arming number, but that is another run.
  std::uint32_t run(std::size_t index) const { return entries_[index].run; }

  /// The first pulse of a run that is not empty.
  std::size_t first_of(std::uint32_t run) const;
  /// Whether the known pulses of this run had different lasers.
  bool lasers_vary(std::uint32_t run) const { return runs_[run].vary; }

  /// The pulse with this count in this run.
  std::optional<std::size_t> find(std::uint32_t run, std::int64_t count) const;

  /// The count of the last pulse of this run; 0 if it has none.
  std::uint64_t last_count(std::uint32_t run) const;

  /// The pulse at an instant.
  struct Place {
    std::optional<std::size_t> pulse;  //!< none: no pulse within the tolerance
    Nanoseconds distance = 0;          //!< from the pulse to the instant
  };

  /// The pulse within `tolerance` of `time`, and within 0.45 of the interval between the pulses
  /// around it, so that there is never a second one.
  Place locate(Nanoseconds time, Nanoseconds tolerance) const;

  /// Whether locate() would return the same whatever pulses still arrive, and the pulse after the
  /// one that it returns is known.
  bool settled(Nanoseconds time) const;

  std::uint64_t refused() const { return refused_; }

 private:
  struct Entry {
    Pulse pulse;
    std::uint32_t run;
  };

  struct Run {
    std::uint8_t lasers = 0;  // of its first pulse
    bool vary = false;
  };

  std::size_t first_after(Nanoseconds time) const;

  std::vector<Entry> entries_;
  std::vector<Run> runs_;
  bool ended_ = false;
  std::uint64_t refused_ = 0;
};

}  // namespace pose_frame_binder
