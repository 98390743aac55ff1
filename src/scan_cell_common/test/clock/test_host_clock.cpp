// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <chrono>

#include "scan_cell_common/clock/host_clock.h"

using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;

TEST(HostClock, IsTheWallClock) {
  const auto now = [] {
    const auto passed = std::chrono::system_clock::now().time_since_epoch();
    return Nanoseconds{std::chrono::duration_cast<std::chrono::nanoseconds>(passed).count()};
  };
  const Nanoseconds before = now();
  const Nanoseconds time = host_now();
  EXPECT_LE(before, time);
  EXPECT_LE(time, now());
}
