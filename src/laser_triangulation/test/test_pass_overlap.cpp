// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "pass_overlap.h"

using namespace laser_triangulation;  // NOLINT

namespace {

/// Profiles of a laser along an inclined plane: 0.6 mm apart, with a point every 0.15 mm.
class Scan {
 public:
  /// @param lift [m] along the plane's normal @param noise [m] deviation
  void sweep(std::uint8_t pass, std::uint8_t laser, double begin, double lift, double noise = 0) {
    std::mt19937 random(pass * 7U + laser);
    std::normal_distribution<double> deviation(0, noise > 0 ? noise : 1e-12);
    const Eigen::AngleAxisd lean(0.4, Eigen::Vector3d(1, 2, 0).normalized());
    std::vector<ScanPoint> points;
    for (double x = begin; x < begin + 0.03; x += 0.6e-3) {
      for (double y = 0; y < 0.02; y += 0.15e-3) {
        const Eigen::Vector3f p =
            (lean * Eigen::Vector3d(x, y, lift + deviation(random))).cast<float>();
        points.push_back({p.x(), p.y(), p.z(), 100, laser, pass, {0, 0}, 3, 0, 0, 1});
      }
    }
    cloud.append(points);
  }

  ScanCloud cloud;
};

}  // namespace

TEST(PassOverlap, IsNoneOfOneSweep) {
  EXPECT_TRUE(compare_sweeps(find_shared_places(ScanCloud())).empty());
  Scan scan;
  scan.sweep(0, 0, 0, 0);
  EXPECT_TRUE(compare_sweeps(find_shared_places(scan.cloud)).empty());
}

TEST(PassOverlap, IsHowFarTheSweepsLieApartAlongTheNormal) {
  Scan scan;
  scan.sweep(0, 0, 0, 0);
  scan.sweep(1, 1, 0.01, 0.25e-3);
  const auto overlaps = compare_sweeps(find_shared_places(scan.cloud));
  ASSERT_EQ(overlaps.size(), 1U);
  EXPECT_EQ(overlaps[0].one.pass, 0);
  EXPECT_EQ(overlaps[0].other.pass, 1);
  EXPECT_EQ(overlaps[0].other.laser, 1);
  EXPECT_NEAR(overlaps[0].median, 0.25e-3, 2e-6);
  EXPECT_NEAR(overlaps[0].most, 0.25e-3, 5e-6);
}

TEST(PassOverlap, IsOfEachPairAndOfTheLasersOfAPass) {
  Scan scan;
  scan.sweep(0, 0, 0, 0);
  scan.sweep(0, 1, 0, 0.1e-3);
  scan.sweep(1, 0, 0, -0.1e-3);
  const auto overlaps = compare_sweeps(find_shared_places(scan.cloud));
  ASSERT_EQ(overlaps.size(), 3U);
  EXPECT_NEAR(overlaps[0].median, 0.1e-3, 2e-6);
  EXPECT_NEAR(overlaps[1].median, 0.1e-3, 2e-6);
  EXPECT_NEAR(overlaps[2].median, 0.2e-3, 2e-6);
}

TEST(PassOverlap, IsLeftOutWhereTheSweepsShareNothing) {
  Scan scan;
  scan.sweep(0, 0, 0, 0);
  scan.sweep(1, 0, 0.2, 0);
  EXPECT_TRUE(compare_sweeps(find_shared_places(scan.cloud)).empty());
}

TEST(PassOverlap, IsTheNoiseWhereTheSweepsAgree) {
  constexpr double kNoise = 30e-6;  // [m] of each point
  Scan scan;
  scan.sweep(0, 0, 0, 0, kNoise);
  scan.sweep(1, 0, 0, 0, kNoise);
  const auto overlaps = compare_sweeps(find_shared_places(scan.cloud));
  ASSERT_EQ(overlaps.size(), 1U);
  // Half of normal deviations are within 0.674, 95 % within 1.96; the patch adds about a tenth.
  EXPECT_NEAR(overlaps[0].median, 0.674 * kNoise, 0.15 * kNoise);
  EXPECT_NEAR(overlaps[0].most, 1.96 * kNoise, 0.3 * kNoise);
}

TEST(PassOverlap, IsFoundAmongHundredsOfSweepsWithoutComparingEachWithEach) {
  Scan scan;
  for (int pass = 0; pass < 200; ++pass)
    scan.sweep(static_cast<std::uint8_t>(pass), 0, 0, pass == 77 ? 0.3e-3 : 0);
  const SharedPlaces shared = find_shared_places(scan.cloud);
  std::size_t patches = 0;
  for (const auto& place : shared.places)
    patches += place.size();
  EXPECT_LE(patches, 500000U) << "a budget for all pairs";
  const auto overlaps = compare_sweeps(shared);
  EXPECT_GT(overlaps.size(), 1000U);
  for (const PassOverlap& overlap : overlaps) {
    const bool lifted = overlap.one.pass == 77 || overlap.other.pass == 77;
    ASSERT_NEAR(overlap.median, lifted ? 0.3e-3 : 0, 5e-6);
  }
  EXPECT_TRUE(sweeps_alone(shared, overlaps).empty());
}
