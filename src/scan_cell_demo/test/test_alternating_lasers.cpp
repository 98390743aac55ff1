// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Trigger, simulated camera, binder and triangulation, over a floor known from the simulator.
#include <gtest/gtest.h>

#include "bench/alternating_chain.h"

using namespace scan_cell_demo;  // NOLINT

namespace {

AlternatingScan scan_of(std::uint64_t pulses) {
  AlternatingScan scan;
  scan.config = CONFIG_FOLDER;
  scan.pulses = pulses;
  return scan;
}

}  // namespace

TEST(AlternatingLasers, GiveNoPointOfTheOtherLasersPlane) {
  AlternatingScan scan = scan_of(400);
  scan.lost_frames = 0.05;
  const AlternatingResult result = run(scan);
  EXPECT_EQ(result.pulses, scan.pulses);
  EXPECT_EQ(result.wrong, 0U) << "farthest " << result.worst << " m off the floor";
  EXPECT_GT(result.swapped, 0.1) << "the other laser's plane would show";
  EXPECT_GT(result.bound, 300U);
  for (const std::uint64_t points : result.points)
    EXPECT_GT(points, 150U * 120U) << "each laser sees the floor in all rows";
}

TEST(AlternatingLasers, GiveNoPointAtAllWhereTheLatencyIsWrongByAPulse) {
  for (const double latency : {-0.01, 0.01}) {
    AlternatingScan scan = scan_of(150);
    scan.camera_latency = latency;  // [s] one period
    const AlternatingResult result = run(scan);
    EXPECT_GT(result.frames, 100U);
    EXPECT_EQ(result.wrong, 0U) << latency;
    if (result.missed == 0) {  // a busy machine skips pulses
      EXPECT_EQ(result.bound, 0U) << latency;
    }
  }
}
