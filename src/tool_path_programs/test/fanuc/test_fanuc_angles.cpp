// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "fanuc_reader/fanuc_angles.h"

namespace tool_path_programs {
namespace {

constexpr double kRadian = M_PI / 180;

Eigen::Isometry3d turned(double w, double p, double r) {
  return pose_of({0, 0, 0, w, p, r});
}

double degrees_between(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) {
  return Eigen::Quaterniond(one.linear()).angularDistance(Eigen::Quaterniond(other.linear())) /
         kRadian;
}

// Formula published by makers of cameras for FANUC's robots (Basler, rc_visard: "FANUC XYZ-WPR
// format"): the quaternion of W, P, R with R = Rz Ry Rx, here for 30, 40, 50 degrees.
TEST(FanucAngles, AreThoseOfThePublishedFormula) {
  const double w = 15 * kRadian, p = 20 * kRadian, r = 25 * kRadian;
  const Eigen::Quaterniond expected(
      std::cos(r) * std::cos(p) * std::cos(w) + std::sin(r) * std::sin(p) * std::sin(w),
      std::cos(r) * std::cos(p) * std::sin(w) - std::sin(r) * std::sin(p) * std::cos(w),
      std::cos(r) * std::sin(p) * std::cos(w) + std::sin(r) * std::cos(p) * std::sin(w),
      std::sin(r) * std::cos(p) * std::cos(w) - std::cos(r) * std::sin(p) * std::sin(w));
  EXPECT_TRUE(turned(30, 40, 50).linear().isApprox(expected.toRotationMatrix(), 1e-12));
}

// A tool that points down, as in many programs: W is 180 degrees.
TEST(FanucAngles, AToolThatPointsDownHasW180) {
  Eigen::Isometry3d down = Eigen::Isometry3d::Identity();
  down.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  const FanucPose numbers = fanuc_pose(down, {3, 3, 3});
  EXPECT_EQ(std::abs(numbers[3]), 180);
  EXPECT_EQ(numbers[4], 0);
  EXPECT_EQ(numbers[5], 0);
}

TEST(FanucAngles, ThreeDigitsBringBackEachTurnToAThousandthAlsoNearLock) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-180, 180);
  std::uniform_real_distribution<double> exponent(-9, 1);
  for (int i = 0; i < 200000; ++i) {
    const double from_lock = i % 10 == 0 ? 0 : std::pow(10, exponent(random));
    const double p = i % 2 == 0 ? 90 - from_lock : -90 + from_lock;
    const Eigen::Isometry3d pose =
        turned(angle(random), i % 3 == 0 ? angle(random) : p, angle(random));
    ASSERT_LT(degrees_between(pose_of(fanuc_pose(pose, {3, 3, 3})), pose), 0.00095) << i;
  }
}

}  // namespace
}  // namespace tool_path_programs
