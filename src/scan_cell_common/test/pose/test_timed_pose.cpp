// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/timed_pose.h"

using scan_cell_common::interpolate;
using scan_cell_common::TimedPose;

namespace {

TimedPose turned(scan_cell_common::Nanoseconds time, double angle, double x) {
  TimedPose pose;
  pose.time = time;
  pose.pose = Eigen::Translation3d(x, 0, 0) * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ());
  return pose;
}

}  // namespace

TEST(Interpolate, MovesAndTurnsAtConstantSpeed) {
  const TimedPose before = turned(1000, 0.2, 1.0);
  const TimedPose after = turned(2000, 0.6, 3.0);
  const Eigen::Isometry3d quarter = interpolate(before, after, 1250);
  EXPECT_TRUE(quarter.isApprox(turned(0, 0.3, 1.5).pose, 1e-12));
}

TEST(Interpolate, TakesTheShortWayRound) {
  const double almost_full_turn = 2 * M_PI - 0.1;
  const Eigen::Isometry3d half = interpolate(turned(0, 0, 0), turned(10, almost_full_turn, 0), 5);
  EXPECT_TRUE(half.isApprox(turned(0, -0.05, 0).pose, 1e-12));
}

TEST(Interpolate, NeverExtrapolates) {
  EXPECT_THROW(interpolate(turned(10, 0, 0), turned(20, 0, 0), 9), scan_cell_common::Refused);
  EXPECT_THROW(interpolate(turned(10, 0, 0), turned(20, 0, 0), 21), scan_cell_common::Refused);
}

TEST(Seconds, KeepNanosecondsBothWays) {
  EXPECT_EQ(scan_cell_common::from_seconds(1.5), 1500000000);
  EXPECT_EQ(scan_cell_common::from_seconds(-0.25), -250000000);
  EXPECT_DOUBLE_EQ(scan_cell_common::to_seconds(2500000000), 2.5);
}
