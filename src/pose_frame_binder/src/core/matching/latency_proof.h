// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "matching/pulse_log.h"

namespace pose_frame_binder {

/// Decides whether the latency is certain, or could be wrong by whole pulse intervals. With steady
/// pulses nothing distinguishes the two: each frame would also fit the pulse beside its own, with a
/// latency longer or shorter by one interval. An interval of another length does distinguish them:
/// only frames matched to the right pulses agree on both sides of it, since with a match one pulse
/// too early or too late the latency jumps there.
///
/// So two other hypotheses ("stories") are followed, in which each frame belongs to the pulse
/// before or after its own. A frame contradicts a story if it fits its own pulse better by a
/// quarter of an interval, or if its pulse is the first and the story would need one before. The
/// latency is proved once both stories are contradicted often enough. If it is wrong by any number
/// of intervals, the frames around an irregular interval do not agree, and one of the stories
/// stays.
class LatencyProof {
 public:
  /// @param contradictions number that ends a story: a single frame may have a wrong stamp
  LatencyProof(const PulseLog& pulses, std::size_t contradictions)
      : pulses_(pulses), needed_(contradictions) {}

  /// Starts again: the frames so far say nothing about those that follow.
  void reset() { before_ = after_ = Story(); }

  /// Adds a frame that agrees, in the order of the pulses. The pulse after its own must be known,
  /// if there is one.
  /// @param distance from the pulse to the frame's stamp minus the latency
  void add(std::size_t pulse, Nanoseconds distance);

  bool holds() const;

 private:
  struct Story {
    std::optional<Nanoseconds> interval;  // from the story's pulse, at the first frame
    Nanoseconds latency = 0;              // beyond the assumed latency, at the first frame
    std::size_t contradictions = 0;
  };

  void add(Story& story, int side, std::size_t pulse, Nanoseconds distance) const;

  const PulseLog& pulses_;
  const std::size_t needed_;
  Story before_;  // each frame belongs to the pulse before its own
  Story after_;   // each frame belongs to the pulse after its own
};

}  // namespace pose_frame_binder
