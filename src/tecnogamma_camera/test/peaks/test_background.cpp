// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "peaks/background.h"
#include "peaks/stripes.h"

using tecnogamma_camera::Background;
using tecnogamma_camera::ImageView;

namespace {

/// Quantile of whole numbers spread evenly over their rounding, from the sorted sample.
double sorted_quantile(std::vector<int> sample, double share) {
  std::sort(sample.begin(), sample.end());
  const double wanted = share * static_cast<double>(sample.size());
  const int value = sample[static_cast<std::size_t>(std::ceil(wanted)) - 1];
  const auto [first, end] = std::equal_range(sample.begin(), sample.end(), value);
  return value - 0.5 +
         (wanted - static_cast<double>(first - sample.begin())) / static_cast<double>(end - first);
}

template <class Pixel>
void compare_with_sorting(int most, int other, unsigned seed) {
  std::mt19937 engine(seed);
  constexpr int kTileColumns = Background<Pixel>::kTileColumns;
  constexpr int kColumns = 6 * kTileColumns, kRows = 300;
  std::vector<Pixel> pixels(kColumns * kRows);
  for (int column = 0; column < kColumns; ++column) {
    // Tiles with the same light on both sides: nothing climbs.
    const int middle = column / kTileColumns % 2 == 0 ? 10 : other;
    for (int row = 0; row < kRows; ++row) {
      const int noise = static_cast<int>(engine() % 9) - 4;
      pixels[row * kColumns + column] = static_cast<Pixel>(std::clamp(middle + noise, 0, most));
    }
  }
  Background<Pixel> background({pixels.data(), kColumns, kRows, kColumns, 0, 0});
  for (const int band : {0, 1, 2}) {
    const int first_row = band * Background<Pixel>::kBandRows;
    const int rows = std::min(Background<Pixel>::kBandRows, kRows - first_row);
    for (int tile = 1; tile < 5; ++tile) {
      const int first = tile * kTileColumns;
      std::vector<int> sample;
      for (const int eighth : {1, 3, 5, 7})
        for (int i = 0; i < kTileColumns; ++i)
          sample.push_back(pixels[(first_row + rows * eighth / 8) * kColumns + first + i]);
      const double upper = sorted_quantile(sample, 0.25), lower = sorted_quantile(sample, 0.05);
      const auto& light = background.tile(first_row, tile);
      EXPECT_NEAR(light.noise, (upper - lower) / 0.9704, 1e-3) << tile;
      EXPECT_NEAR(light.background, upper + 0.6745 * light.noise, 1e-3) << tile;
    }
  }
}

}  // namespace

TEST(Background, IsThatOfTheSortedSample) {
  for (const int other : {10, 12, 100, 255})
    compare_with_sorting<std::uint8_t>(255, other, 1);
  for (const int other : {10, 600, 4095, 65535})
    compare_with_sorting<std::uint16_t>(65535, other, 2);
}

TEST(Background, IsTheNoisesOwnWhereALineCrossesIt) {
  stripes::Image picture(256, 256, 40);
  for (int row = 0; row < 256; ++row)
    picture.add(row, {60, 4, 900});
  picture.add_noise(5, 1);
  Background<std::uint8_t> background(picture.view());
  for (const int tile : {0, 1}) {
    EXPECT_NEAR(background.tile(0, tile).background, 40, tile == 0 ? 4 : 1.5);
    EXPECT_NEAR(background.tile(0, tile).noise, 5, 1.5);
  }
}

TEST(Background, KnowsNoiseThatBlackCutsOff) {
  for (const double black : {0.1, 0.25, 0.5, 0.65}) {
    constexpr double kNoise = 4;
    // So far above black that this share of a normal distribution is rounded to black.
    const double deviations = black == 0.1    ? 1.2816
                              : black == 0.25 ? 0.6745
                              : black == 0.5  ? 0
                                              : -0.3853;
    stripes::Image picture(640, 128, 0.5 + deviations * kNoise);
    picture.add_noise(kNoise, 2);
    Background<std::uint8_t> background(picture.view());
    double mean = 0;
    for (int tile = 0; tile < 5; ++tile)
      mean += background.tile(0, tile).noise / 5;
    EXPECT_NEAR(mean, kNoise, 0.1 * kNoise) << black;
    EXPECT_NEAR(background.tile(0, 2).background, std::max(0.0, 0.5 + deviations * kNoise), 1);
  }
}

TEST(Background, HasTheSlopeOfAnAmbientGradientAndNotInItsNoise) {
  for (const int columns : {640, 700, 770, 260}) {
    for (const double slope : {0.1, 0.3, -0.2}) {
      stripes::Image picture(columns, 10, slope > 0 ? 20 : 180);
      for (int row = 0; row < 10; ++row)
        for (int column = 0; column < columns; ++column)
          picture.at(row, column) += slope * column;
      picture.add_noise(2, 1);
      Background<std::uint8_t> background(picture.view());
      for (int column = 0; column < columns; column += 7) {
        const auto line = background.about(5, column);
        EXPECT_NEAR(line.slope, slope, 0.02) << column;
        EXPECT_NEAR(line.value, (slope > 0 ? 20 : 180) + slope * column, 2) << column;
        EXPECT_NEAR(background.tile(5, background.tile_of(column)).noise, 2, 1) << column;
      }
    }
  }
}

TEST(Background, DividesEveryWidthIntoTilesOfAboutTheSameWidth) {
  for (int columns = 1; columns < 2000; ++columns) {
    Background<std::uint8_t> background({nullptr, columns, 0, columns, 0, 0});
    int last = 0, width = 0;
    for (int column = 0; column < columns; ++column) {
      const int tile = background.tile_of(column);
      width = tile == last ? width + 1 : 1;
      ASSERT_TRUE(tile == last || tile == last + 1) << column << " of " << columns;
      ASSERT_LE(width, 192) << columns;
      last = tile;
    }
    ASSERT_EQ(last, background.tiles() - 1) << columns;
  }
}
