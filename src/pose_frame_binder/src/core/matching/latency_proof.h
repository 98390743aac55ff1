// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "matching/pulse_log.h"

namespace pose_frame_binder {

/// Whether the latency is certain, or could be wrong by whole pulse intervals. Where pulses are
/// steady nothing tells: each frame would fit the pulse beside its own as well, with a latency that
/// is one interval more or less. An interval of another length does. Only frames of the right
/// pulses agree on both sides of it, since from one pulse too early or too late the latency jumps
/// there.
///
/// So two other stories are followed, in which each frame is of the pulse before or after the one
/// that it was given. Each frame that fits its own pulse by a quarter of an interval better than it
/// fits the story contradicts it, and so does a frame of the first pulse that would be of one
/// before. The latency is proved once both stories are contradicted often enough. Where it is wrong
/// by any number of intervals, the frames around an irregular one do not agree, and one of the
/// stories stays.
class LatencyProof {
 public:
  /// @param contradictions of frames that end a story: one alone may have a wrong stamp
  LatencyProof(const PulseLog& pulses, std::size_t contradictions)
      : pulses_(pulses), needed_(contradictions) {}

  /// The frames up to now say nothing of those that follow.
  void reset() { before_ = after_ = Story(); }

  /// A frame that agrees, in the order of the pulses. The pulse after its own must be known, if
  /// there is one.
  /// @param distance from the pulse to the frame's stamp less the latency
  void add(std::size_t pulse, Nanoseconds distance);

  bool holds() const;

 private:
  struct Story {
    std::optional<Nanoseconds> interval;  // from the story's pulse, at the first frame
    Nanoseconds latency = 0;              // more than the one assumed, at the first frame
    std::size_t contradictions = 0;
  };

  void add(Story& story, int side, std::size_t pulse, Nanoseconds distance) const;

  const PulseLog& pulses_;
  const std::size_t needed_;
  Story before_;  // each frame is of the pulse before the one that it was given
  Story after_;   // the same, after
};

}  // namespace pose_frame_binder
