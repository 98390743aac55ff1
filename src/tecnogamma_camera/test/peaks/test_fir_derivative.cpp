// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../src/bench/peak_accuracy.h"
#include "peaks/fir_derivative.h"
#include "peaks/stripes.h"
#include "tecnogamma_camera/peak_detector.h"

using tecnogamma_camera::filter_for;
using tecnogamma_camera::zero_crossing;

namespace {

/// Maximum of the row smoothed by a Gaussian, searched on a fine grid.
double maximum_of_smoothed(const std::vector<std::uint8_t>& row, double sigma, double from,
                           double to) {
  double best = from, most = 0;
  for (double place = from; place <= to; place += 1e-3) {
    double sum = 0;
    for (std::size_t i = 0; i < row.size(); ++i)
      sum += row[i] * std::exp(-0.5 * std::pow((static_cast<double>(i) - place) / sigma, 2));
    if (sum > most) {
      most = sum;
      best = place;
    }
  }
  return best;
}

}  // namespace

TEST(DerivativeFilter, IsZeroOnALevelAndKnowsItsOutputForASlope) {
  std::vector<std::uint16_t> level(100, 500), slope(100);
  for (int i = 0; i < 100; ++i)
    slope[i] = static_cast<std::uint16_t>(100 + 3 * i);
  for (const double width : {1.0, 4.0, 12.0, 30.0}) {
    const auto& filter = filter_for(width);
    EXPECT_EQ(derivative(level.data(), 100, filter, 50), 0);
    EXPECT_NEAR(derivative(slope.data(), 100, filter, 50), 3 * filter.slope_response,
                1e-9 * filter.slope_response);
  }
}

TEST(DerivativeFilter, IsOfTheStripesOwnSigma) {
  for (double sigma = 1.0; sigma < 23; sigma *= 1.05)
    EXPECT_NEAR(filter_for(2.3548 * sigma).sigma / sigma, 1, 0.145) << sigma;
  EXPECT_EQ(filter_for(0.1).sigma, 1.0);
  EXPECT_EQ(filter_for(1e6).sigma, filter_for(100).sigma);
}

TEST(FirDerivative, FindsTheMaximumOfTheSmoothedRow) {
  std::mt19937 engine(2);
  for (int i = 0; i < 30; ++i) {
    stripes::Image picture(60, 1, 10);
    const double centre = 28 + 4 * std::generate_canonical<double, 32>(engine);
    const double sigma = 1 + 2 * std::generate_canonical<double, 32>(engine);
    picture.add(0, {centre, sigma, 180});
    picture.add_translucent(0, {centre, sigma, 30}, 3, 0.3);
    const auto view = picture.view();
    const double width = 2.3548 * sigma;
    const int rise = static_cast<int>(centre - width / 2);
    const int fall = static_cast<int>(centre + width / 2) + 1;
    const double found = zero_crossing(view.pixels, 60, {rise, fall, width, 0});
    const std::vector<std::uint8_t> row(view.pixels, view.pixels + 60);
    EXPECT_NEAR(found, maximum_of_smoothed(row, filter_for(width).sigma, centre - 2, centre + 3),
                0.01);
  }
}

TEST(FirDerivative, TakesTheMiddleOfASaturatedPlateau) {
  std::vector<std::uint8_t> row(400, 10);
  std::fill(row.begin() + 100, row.begin() + 301, 255);
  EXPECT_NEAR(zero_crossing(row.data(), 400, {100, 301, 201, 0}), 200, 1e-9);
}

TEST(FirDerivative, HasNoPeakWhereTheRowOnlyClimbs) {
  std::vector<std::uint8_t> row(100);
  for (int i = 0; i < 100; ++i)
    row[i] = static_cast<std::uint8_t>(2 * i);
  EXPECT_TRUE(std::isnan(zero_crossing(row.data(), 100, {40, 60, 10, 0})));
}

TEST(CramerRaoBound, IsThatOfAContinuousRowForAWideStripe) {
  // A pixel widens the stripe by the variance of its own width, 1/12, and lowers it accordingly.
  const double seen = std::sqrt(16 + 1.0 / 12);
  const double height = 120 * 4 / seen;
  const double noise = std::sqrt(9 - 1.0 / 12);  // 3 with the rounding
  EXPECT_NEAR(tecnogamma_camera::cramer_rao_bound(50.3, 4, {120, 10, noise, 0}),
              3 / height * std::sqrt(2 * seen / std::sqrt(M_PI)), 1e-5);
}

TEST(CramerRaoBound, IsThatOfCountedLightInShotNoiseAlone) {
  // Without read noise, each photon gives the position to within the stripe's sigma: sigma /
  // sqrt(N)
  constexpr double kSigma = 5, kHeight = 200, kShot = 100;
  const double photons = kHeight * kSigma * std::sqrt(2 * M_PI) / (kShot * kShot);
  EXPECT_NEAR(tecnogamma_camera::cramer_rao_bound(50.3, kSigma, {kHeight, 0, 0, kShot}) /
                  std::sqrt((kSigma * kSigma + 1.0 / 12) / photons),
              1, 1e-3);
}

TEST(FirDerivative, ScattersAsTheCramerRaoBoundSaysAndIsUnbiased) {
  constexpr int kRows = 20000;
  for (const double sigma : {1.0, 2.0, 4.0, 6.0}) {
    for (const double noise : {2.0, 6.0}) {
      stripes::Image picture(160, kRows, 30);
      for (int row = 0; row < kRows; ++row)
        picture.add(row, {80 + row * 1e-4, sigma, 120});
      picture.add_noise(noise, 7);
      tecnogamma_camera::PeakProfile profile;
      tecnogamma_camera::make_detector("fir_derivative", {})->detect(picture.view(), profile);
      double sum = 0, squares = 0;
      for (int row = 0; row < kRows; ++row) {
        const double error = profile.position[row] - (80 + row * 1e-4);
        ASSERT_FALSE(std::isnan(error));
        sum += error;
        squares += error * error;
      }
      const double bound = tecnogamma_camera::cramer_rao_bound(80.5, sigma, {120, 30, noise, 0});
      EXPECT_LT(std::sqrt(squares / kRows), 1.1 * bound) << sigma << " px, noise " << noise;
      EXPECT_GT(std::sqrt(squares / kRows), 0.95 * bound) << sigma << " px, noise " << noise;
      EXPECT_LT(std::abs(sum / kRows), std::max(0.004, 4 * bound / std::sqrt(kRows)))
          << sigma << " px, noise " << noise;
    }
  }
}
