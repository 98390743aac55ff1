// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "scan_cell_common/clock_map.h"
#include "scan_cell_common/errors.h"

using scan_cell_common::ClockMap;
using scan_cell_common::Nanoseconds;

constexpr Nanoseconds kMillisecond = 1000000;

TEST(ClockMap, ForgetsTheJitterOfTheWire) {
  std::mt19937 generator(1);
  std::exponential_distribution<double> delay(1.0 / 3e6);  // 3 ms in the mean
  ClockMap map(1000 * kMillisecond);
  const Nanoseconds offset = 1700000000000000000;
  Nanoseconds device = 0;
  for (int i = 0; i < 500; ++i) {
    device += 2 * kMillisecond;
    map.add(device, device + offset + 50000 + static_cast<Nanoseconds>(delay(generator)));
  }
  EXPECT_GE(map.to_host(device), device + offset + 50000);
  EXPECT_LT(map.to_host(device), device + offset + 150000);
}

TEST(ClockMap, FollowsADriftingDevice) {
  ClockMap map(1000 * kMillisecond);
  Nanoseconds true_offset = 0;
  for (Nanoseconds device = 0; device < 60000 * kMillisecond; device += 10 * kMillisecond) {
    true_offset = device / 10000;  // 100 ppm, the device is slow
    map.add(device, device + true_offset);
  }
  EXPECT_NEAR(map.to_host(60000 * kMillisecond) - 60000 * kMillisecond, true_offset,
              0.11 * kMillisecond);
}

TEST(ClockMap, StartsAnewWhenTheDeviceRestarts) {
  ClockMap map(1000 * kMillisecond);
  map.add(500 * kMillisecond, 600 * kMillisecond);
  map.add(1 * kMillisecond, 900 * kMillisecond);
  EXPECT_EQ(map.to_host(2 * kMillisecond), 901 * kMillisecond);
}

TEST(ClockMap, RefusesToGuessBeforeTheFirstMessage) {
  EXPECT_THROW(ClockMap(1).to_host(0), scan_cell_common::Refused);
  EXPECT_THROW(ClockMap(0), scan_cell_common::InvalidParameter);
}
