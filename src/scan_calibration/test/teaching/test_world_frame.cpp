// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scan_cell_common/errors/errors.h"
#include "teaching/world_frame.h"

using Eigen::Vector3d;
using scan_calibration::world_from_points;
using scan_calibration::WorldFrame;

namespace {

std::string refused(const Vector3d& o, const Vector3d& x, const Vector3d& xy) {
  try {
    world_from_points(o, x, xy);
  } catch (const scan_cell_common::UnusableInput& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

TEST(WorldFrame, IsTheOneThePointsWereTakenFrom) {
  const Eigen::Isometry3d world = Eigen::Translation3d(0.7, -0.2, 0.05) *
                                  Eigen::AngleAxisd(2.0, Vector3d(1, -2, 3).normalized());
  const WorldFrame found = world_from_points(world * Vector3d::Zero(), world * Vector3d(0.3, 0, 0),
                                             world * Vector3d(0.3, 0.2, 0));
  EXPECT_TRUE(found.pose.isApprox(world, 1e-12));
  EXPECT_NEAR(found.skew, 0, 1e-12);
}

TEST(WorldFrame, TakesXExactlyAndSaysHowFarXyIsOffTheRightAngle) {
  const double skew = 0.02;
  const WorldFrame found =
      world_from_points(Vector3d::Zero(), {0.3, 0, 0}, {0.3 + 0.2 * std::tan(skew), 0.2, 0});
  EXPECT_NEAR(found.skew, skew, 1e-12);
  EXPECT_TRUE(found.pose.matrix().isIdentity(1e-12));
}

TEST(WorldFrame, IsRefusedWithTheFigureWhereThePointsDoNotSpanAPlane) {
  EXPECT_EQ(refused({0, 0, 0}, {0.01, 0, 0}, {0.01, 0.2, 0}),
            "distance from O to X: 10.00 mm; teach X further from O, at least 50.00 mm");
  EXPECT_EQ(refused({0, 0, 0}, {0.3, 0, 0}, {0.6, 0.004, 0}),
            "distance from XY to the line through O and X: 4.00 mm; "
            "teach XY further from that line, at least 50.00 mm");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refused({0, 0, 0}, {0.3, nan, 0}, {0.3, 0.2, 0}), "nothing");
  EXPECT_NE(refused({0, 0, 0}, {0.3, 0, 0}, {0.3, 0.2, nan}), "nothing");
}

TEST(WorldFrame, IsRefusedWhereXyWasTaughtOnTheYAxisOfAnotherPoint) {
  EXPECT_EQ(refused({0, 0, 0}, {0.2, 0, 0}, {0, 0.2, 0}),
            "angle O-X-XY: 45.00 deg; teach XY on the parallel to the Y axis through X");
}
