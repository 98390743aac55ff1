// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "rewrite/circle.h"

namespace tool_path_programs {
namespace {

const Eigen::Vector3d kCentre(1, 2, 3);

/// On a circle of radius 0.5 in a tilted plane.
Eigen::Vector3d at(double degrees) {
  const double angle = degrees * M_PI / 180;
  const Eigen::Vector3d u = Eigen::Vector3d(1, 1, 0).normalized();
  const Eigen::Vector3d v = Eigen::Vector3d(1, -1, 2).normalized();
  return kCentre + 0.5 * (std::cos(angle) * u + std::sin(angle) * v);
}

TEST(Circle, GoesThroughItsThreePoints) {
  const auto circle = Circle::through(at(10), at(100), at(250));
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius(), 0.5, 1e-12);
  EXPECT_NEAR(circle->distance(at(300)), 0, 1e-12);
  EXPECT_NEAR(circle->distance(kCentre + 0.6 * (at(40) - kCentre) / 0.5), 0.1, 1e-12);
}

TEST(Circle, PlacesLieOnTheArcAndNotBeyondIt) {
  const auto circle = Circle::through(at(10), at(100), at(250));
  const auto places = circle->places(0.05);
  // 90 degrees are 0.785 m: 15 places between; 150 degrees 1.309 m: 26
  ASSERT_EQ(places.size(), 15u + 26u);
  EXPECT_TRUE(places.front().position.isApprox(at(10 + 90. / 16), 1e-12));
  EXPECT_NEAR(places[14].angle, (90 - 90. / 16) * M_PI / 180, 1e-12);
  EXPECT_NEAR(places[15].angle, (90 + 150. / 27) * M_PI / 180, 1e-12);
  EXPECT_NEAR(circle->via_angle(), M_PI / 2, 1e-12);
  EXPECT_NEAR(circle->sweep(), 240 * M_PI / 180, 1e-12);
  EXPECT_TRUE(places[14].position.isApprox(at(100 - 90. / 16), 1e-12));
  EXPECT_TRUE(places.back().position.isApprox(at(250 - 150. / 27), 1e-12));
}

TEST(Circle, TheLongWayRoundIsWhereViaIs) {
  const auto circle = Circle::through(at(0), at(-100), at(90));
  EXPECT_TRUE(circle->places(10).empty());
  EXPECT_TRUE(
      circle->places(0.5 * M_PI * 100 / 180 / 1.5).front().position.isApprox(at(-50), 1e-12));
}

TEST(Circle, IsNoneThroughPointsOfALine) {
  EXPECT_FALSE(Circle::through({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
  EXPECT_FALSE(Circle::through({0, 0, 0}, {0, 0, 0}, {2, 2, 2}));
}

}  // namespace
}  // namespace tool_path_programs
