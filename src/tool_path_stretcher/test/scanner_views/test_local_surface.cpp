// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "local_surface/local_surface.h"
#include "scanner_views/blocks.h"

using namespace scanner_views;
using namespace tool_path_stretcher;
using Eigen::Vector3d;

namespace {

constexpr double kHalf = 0.05, kHeight = 0.02;  // [m] of the block
constexpr double kRadius = 0.003;               // [m] of the fit
constexpr double kNoise = 2e-5;                 // [m]

/// The block's top and the wall at its edge along y, with points every millimetre as from a line
/// scanner.
/// @param lowered [m] of the top, as a function of the distance from the edge
template <class Lowered>
Surface scanned(const Lowered& lowered) {
  constexpr double kStep = 0.001;
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, kNoise);
  Points points;
  for (double y = -kHalf; y <= kHalf; y += kStep) {
    for (double away = kStep / 2; away < 2 * kHalf; away += kStep)
      points.emplace_back(kHalf - away, y, kHeight - lowered(away) + noise(random));
    for (double down = kStep; down < kHeight; down += kStep)
      points.emplace_back(kHalf + noise(random), y, kHeight - down);
  }
  return surface_from_cloud(points, Vector3d::Constant(kStep / 10), "scan");
}

/// @param away [m] from the edge
LocalSurface fitted_at(double away, const Surface& scan) {
  constexpr int kSupport = 6;
  constexpr double kStranger = 0.005;
  const Surface reference = surface_of(block(2 * kHalf, 2 * kHalf, kHeight));
  const Mapping mapping;
  const LocalSurfaceFitter fitter({reference, scan}, mapping, kRadius, kSupport, kStranger);
  return fitter.fit({kHalf - away, 0, kHeight}, Eigen::Matrix3d::Zero());
}

/// The surface from a scan whose mixed points round off the edge over 2 mm.
LocalSurface beside_rounded_edge() {
  return fitted_at(0.001, scanned([](double away) {
                     constexpr double kOff = 0.0004, kOver = 0.002;
                     return away < kOver ? kOff * std::pow(1 - away / kOver, 2) : 0.0;
                   }));
}

}  // namespace

TEST(LocalSurface, BesideAnEdgeThatTheScanRoundsOffKnowsThatItsSlopeMayBeNone) {
  const LocalSurface surface = beside_rounded_edge();
  ASSERT_TRUE(surface.measured);
  EXPECT_GT(surface.slope.norm(), 0.03);
  EXPECT_LT(surface.slope.norm(), 3 * std::sqrt(surface.slope_variance));
}

TEST(LocalSurface, OnAFaceThatIsTiltedKnowsItsSlope) {
  constexpr double kSlope = 0.05;
  const LocalSurface surface =
      fitted_at(kHalf, scanned([](double away) { return kSlope * (away - kHalf); }));
  ASSERT_TRUE(surface.measured);
  EXPECT_NEAR(surface.slope.norm(), kSlope, kSlope / 10);
  EXPECT_LT(std::sqrt(surface.slope_variance), kSlope / 9);
  EXPECT_LT(std::abs(surface.height), 3 * kNoise);
}
