// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scan_cell_common/colours/colour_scale.h"

namespace scan_cell_common {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

float luminance(const Rgb& rgb) {  // Rec. 709
  return 0.2126F * rgb[0] + 0.7152F * rgb[1] + 0.0722F * rgb[2];
}

TEST(ColourScale, ThatBrightensCanBeReadWithoutColour) {
  for (int i = 0; i < 20; ++i)
    EXPECT_LT(luminance(brightening(0.05 * i)), luminance(brightening(0.05 * (i + 1)))) << i;
  EXPECT_EQ(brightening(-1), brightening(0));
  EXPECT_EQ(brightening(2), brightening(1));
}

TEST(ColourScale, ThatDivergesIsPalestInTheMiddleAndBlueOnOneSideOnly) {
  for (int i = 0; i < 10; ++i) {
    for (const int side : {-1, 1})
      EXPECT_GT(luminance(diverging(0.1 * side * i)), luminance(diverging(0.1 * side * (i + 1))));
  }
  EXPECT_GT(diverging(-0.5)[2], diverging(-0.5)[0]);
  EXPECT_LT(diverging(0.5)[2], diverging(0.5)[0]);
  EXPECT_EQ(diverging(-3), diverging(-1));
  EXPECT_EQ(diverging(3), diverging(1));
}

TEST(ColourScale, HasAColourOfItsOwnForWhatIsNotKnown) {
  for (int i = -20; i <= 20; ++i)
    EXPECT_NE(diverging(0.05 * i), diverging(kNone));
  for (int i = 0; i <= 20; ++i)
    EXPECT_NE(brightening(0.05 * i), brightening(kNone));
}

}  // namespace
}  // namespace scan_cell_common
