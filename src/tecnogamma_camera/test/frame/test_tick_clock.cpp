// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "frame/tick_clock.h"

using scan_cell_common::Nanoseconds;
using tecnogamma_camera::TickClock;

namespace {

constexpr Nanoseconds kMicrosecond = 1000;
constexpr Nanoseconds kTurn = (Nanoseconds{1} << 32) * kMicrosecond;  // 72 minutes

}  // namespace

TEST(TickClock, GoesOnAcrossTheTurn) {
  TickClock clock(1000);
  Nanoseconds host = 5'000'000'000;
  const Nanoseconds before = clock.unwrap(0xFFFFFFF0, host);
  host += 32 * kMicrosecond;
  EXPECT_EQ(clock.unwrap(0x10, host) - before, 32 * kMicrosecond);
  EXPECT_EQ(clock.unwrap(0xFFFFFFF4, host) - before, 4 * kMicrosecond) << "late";
  EXPECT_EQ(clock.unwrap(0x18, host) - before, 40 * kMicrosecond) << "the host runs behind";
}

TEST(TickClock, KnowsHowManyTurnsAPauseTook) {
  TickClock clock(1000);
  Nanoseconds host = 5'000'000'000;
  const Nanoseconds before = clock.unwrap(1000, host);
  host += 3 * kTurn + kTurn / 4;
  const auto raw = static_cast<std::uint32_t>(1000 + (1U << 30));
  EXPECT_EQ(clock.unwrap(raw, host) - before, 3 * kTurn + kTurn / 4);
}

TEST(TickClock, StandsTheJitterOfTheHostAndALateFrame) {
  TickClock clock(1000);
  const Nanoseconds host = 5'000'000'000;
  const Nanoseconds before = clock.unwrap(2000, host);
  EXPECT_EQ(clock.unwrap(3000, host - 40'000'000) - before, 1000 * kMicrosecond);
  EXPECT_EQ(clock.unwrap(2500, host + 700'000'000) - before, 500 * kMicrosecond);
}

TEST(TickClock, IsNeverZeroWhichWouldMeanUnknown) {
  TickClock clock(1000);
  EXPECT_GT(clock.unwrap(0, 0), 0);
  clock.reset();
  EXPECT_GT(clock.unwrap(0, 0), 0);
  EXPECT_GT(clock.unwrap(5, -kTurn), 0) << "the host's clock was set back";
}
