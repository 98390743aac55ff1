// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "deviation/statistics.h"

TEST(DeviationStatistics, LeaveOutWhatIsNotKnown) {
  const auto statistics = part_recipes::statistics_of({0.003, NAN, -0.004, 0.0, NAN, 0.001}, 0.001);
  EXPECT_EQ(statistics.points, 6U);
  EXPECT_EQ(statistics.unknown, 2U);
  EXPECT_NEAR(*statistics.rms, std::sqrt((9e-6 + 16e-6 + 1e-6) / 4), 1e-12);
  EXPECT_NEAR(*statistics.median, 0.0005, 1e-12);
  EXPECT_EQ(*statistics.min, -0.004);
  EXPECT_EQ(*statistics.max, 0.003);
  EXPECT_EQ(*statistics.within_tolerance, 0.5);
}

TEST(DeviationStatistics, OfNothingKnownAreNone) {
  const auto statistics = part_recipes::statistics_of({NAN, NAN}, 0.001);
  EXPECT_EQ(statistics.unknown, 2U);
  EXPECT_FALSE(statistics.rms || statistics.median || statistics.min || statistics.max ||
               statistics.within_tolerance);
}

TEST(Median, IsTheMiddleOrTheMeanOfTheTwo) {
  EXPECT_EQ(part_recipes::median_of({5}), 5);
  EXPECT_EQ(part_recipes::median_of({9, 1, 5}), 5);
  EXPECT_EQ(part_recipes::median_of({9, 1, 5, 3}), 4);
}
