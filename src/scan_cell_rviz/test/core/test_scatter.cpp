// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "edit/scatter.h"

namespace scan_cell_rviz {
namespace {

constexpr std::size_t kPieces = 50;

TEST(ScatteredPoints, AreEachInOnePiece) {
  constexpr std::size_t kEach = 400;
  std::vector<int> times(kPieces * kEach, 0);
  for (std::size_t piece = 0; piece < kPieces; ++piece)
    for (std::size_t number = 0; number < kEach; ++number)
      ++times.at(scattered(piece, number, kPieces));
  EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(times.size()));
}

TEST(ScatteredPoints, AreNoStripesOfAScanWhoseLinesAreAsLong) {
  constexpr std::size_t kLines = 5000;
  std::vector<int> in_column(kPieces, 0);
  for (std::size_t number = 0; number < kLines; ++number)
    ++in_column[scattered(0, number, kPieces) % kPieces];
  const auto [fewest, most] = std::minmax_element(in_column.begin(), in_column.end());
  EXPECT_GT(*fewest, kLines / kPieces / 2);
  EXPECT_LT(*most, 2 * kLines / kPieces);
}

}  // namespace
}  // namespace scan_cell_rviz
