// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <set>

#include "synthetic_scan.h"

namespace pose_frame_binder {

/// Expects no frame to have a pulse other than the one that exposed it; returns how many have one.
inline std::size_t count_right(const SyntheticScan& scan, const Outcome& outcome) {
  std::size_t right = 0;
  for (const Decision& decision : outcome.decisions) {
    if (!decision.match) continue;
    const std::int64_t truth = scan.truth[decision.frame];
    EXPECT_GE(truth, 0) << "frame " << decision.frame << " has no pulse";
    if (truth < 0) continue;
    EXPECT_EQ(decision.match->pulse.time, scan.pulses[static_cast<std::size_t>(truth)].time)
        << "frame " << decision.frame;
    ++right;
  }
  return right;
}

/// Expects no frame to have a laser other than the one that was on with its pulse; returns how many
/// have it.
inline std::size_t count_lit(const SyntheticScan& scan, const Outcome& outcome) {
  std::size_t lit = 0;
  for (const Decision& decision : outcome.decisions) {
    if (!decision.match) continue;
    const std::int64_t truth = scan.truth[decision.frame];
    const std::uint8_t lasers =
        truth < 0 ? std::uint8_t{0} : scan.pulses[static_cast<std::size_t>(truth)].lasers;
    EXPECT_EQ(1 << decision.match->laser, lasers) << "frame " << decision.frame;
    ++lit;
  }
  return lit;
}

/// Expects every frame to be decided once, and every pulse to be bound, named by a drop, or never
/// arrived.
inline void expect_all_accounted(const SyntheticScan& scan, const Outcome& outcome) {
  const Audit& audit = outcome.audit;
  EXPECT_EQ(audit.frames, scan.frames.size());
  EXPECT_EQ(audit.frames, audit.frames_bound + audit.frames_dropped);
  EXPECT_EQ(audit.triggers, scan.pulses.size());
  std::set<std::size_t> decided;
  for (const Decision& decision : outcome.decisions)
    EXPECT_TRUE(decided.insert(decision.frame).second);
  EXPECT_EQ(decided.size(), scan.frames.size());

  std::set<std::uint64_t> bound, dropped;
  for (const Decision& decision : outcome.decisions)
    if (decision.match) {
      EXPECT_TRUE(bound.insert(decision.match->pulse.count).second);
    }
  std::uint64_t never = 0;
  for (const Drop& drop : audit.dropped) {
    if (drop.reason == DropReason::kNeverArrived) {
      ++never;
      EXPECT_EQ(bound.count(drop.trigger_count) + dropped.count(drop.trigger_count), 0U);
    } else if (drop.trigger_count > 0 && bound.count(drop.trigger_count) == 0) {
      dropped.insert(drop.trigger_count);
    }
  }
  EXPECT_EQ(never, audit.frames_never_arrived);
  EXPECT_EQ(bound.size() + dropped.size() + never, scan.pulses.size());
}

}  // namespace pose_frame_binder
