// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/latency_proof.h"

#include <algorithm>

namespace pose_frame_binder {

void LatencyProof::add(std::size_t pulse, Nanoseconds distance) {
  add(before_, -1, pulse, distance);
  add(after_, +1, pulse, distance);
}

void LatencyProof::add(Story& story, int side, std::size_t pulse, Nanoseconds distance) const {
  const auto count = static_cast<std::int64_t>(pulses_[pulse].count) + side;
  if (count < 1) {
    ++story.contradictions;
    return;
  }
  const std::optional<std::size_t> other = pulses_.find(pulses_.run(pulse), count);
  if (!other) return;  // its event was lost, or this is the last pulse
  const Nanoseconds interval = pulses_[pulse].time - pulses_[*other].time;
  const Nanoseconds latency = distance + interval;
  if (!story.interval) {
    // A wrong stamp would be taken for the hypothesis' own latency.
    if (std::abs(distance) > std::abs(interval) / 8) return;
    story.interval = interval;
    story.latency = latency;
    return;
  }
  const Nanoseconds quarter = std::min(std::abs(interval), std::abs(*story.interval)) / 4;
  const Nanoseconds off = std::abs(latency - story.latency);
  if (off > std::abs(distance) + quarter) ++story.contradictions;
}

bool LatencyProof::holds() const {
  return std::min(before_.contradictions, after_.contradictions) >= needed_;
}

}  // namespace pose_frame_binder
