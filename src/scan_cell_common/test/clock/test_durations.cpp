// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "scan_cell_common/clock/durations.h"

using scan_cell_common::Durations;
using scan_cell_common::Nanoseconds;

TEST(Durations, GiveQuantilesToATenthAndNeverTooSmall) {
  std::mt19937 random(3);
  std::lognormal_distribution<double> times(std::log(1e5), 2);
  Durations durations;
  std::vector<Nanoseconds> all;
  for (int i = 0; i < 10'000; ++i) {
    all.push_back(std::max<Nanoseconds>(1000, std::llround(times(random))));
    durations.add(all.back());
  }
  std::sort(all.begin(), all.end());
  for (const double share : {0.01, 0.5, 0.9, 0.99, 0.999}) {
    const auto exact = static_cast<double>(all[static_cast<std::size_t>(share * 10'000) - 1]);
    EXPECT_GE(static_cast<double>(durations.quantile(share)), exact * 0.999) << share;
    EXPECT_LE(static_cast<double>(durations.quantile(share)), exact * 1.1) << share;
  }
}

TEST(Durations, ForgetWhatWasThereBefore) {
  Durations durations;
  EXPECT_EQ(durations.quantile(0.5), 0);
  durations.add(1'000'000'000);
  const Durations before = durations;
  durations.add(5'000);
  EXPECT_EQ(durations.since(before).count(), 1u);
  EXPECT_LT(durations.since(before).quantile(1), 6'000);
  EXPECT_GT(durations.quantile(1), 999'000'000);
}

TEST(Durations, TakeTheShortestAndTheLongest) {
  Durations durations;
  durations.add(-5);
  durations.add(INT64_MAX);
  EXPECT_LT(durations.quantile(0.5), 2'000);
  EXPECT_GT(durations.quantile(1), 16'000'000'000);
}
