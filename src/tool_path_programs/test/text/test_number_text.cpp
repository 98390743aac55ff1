// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "text/number_text.h"

namespace tool_path_programs {
namespace {

TEST(NumberText, HasAsManyDigitsAsAsked) {
  EXPECT_EQ(fixed(1.23456, 3), "1.235");
  EXPECT_EQ(fixed(-150, 3), "-150.000");
  EXPECT_EQ(fixed(2.5e7, 1), "25000000.0");
}

TEST(NumberText, ZeroHasNoSign) {
  EXPECT_EQ(fixed(-1e-9, 3), "0.000");
  EXPECT_EQ(fixed(-0.0, 0), "0");
  EXPECT_EQ(fixed(-0.0005001, 3), "-0.001");
}

TEST(NumberText, ShortestLeavesOutZerosAtTheEnd) {
  EXPECT_EQ(shortest(12.5, 4), "12.5");
  EXPECT_EQ(shortest(100, 4), "100");
  EXPECT_EQ(shortest(-0.00001, 4), "0");
}

TEST(NumberText, ReplacementKeepsTheDigitsThatWereThere) {
  EXPECT_EQ(like("12.34567", 1, 3), "1.00000");
  EXPECT_EQ(like("12", 1.5, 3), "1.500");
  EXPECT_EQ(like("1.25e2", 130, 1), "130.00");
}

}  // namespace
}  // namespace tool_path_programs
