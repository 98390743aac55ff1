// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "krl_values/krl_conventions.h"

namespace tool_path_programs {
namespace {

Eigen::Matrix3d turn(double a, double b, double c) {
  return krl_pose({0, 0, 0, a, b, c}).linear();
}

Eigen::Matrix3d matrix(const Eigen::Vector3d& x, const Eigen::Vector3d& y,
                       const Eigen::Vector3d& z) {
  return (Eigen::Matrix3d() << x, y, z).finished();
}

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();
const Eigen::Vector3d kY = Eigen::Vector3d::UnitY();
const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();

/// KUKA's operating instructions for integrators (KSS 8), "coordinate systems": A turns about Z, B
/// about the new Y, C about the new X.
TEST(KrlAngles, AreAboutZThenYThenXEachTurnedByTheOnesBefore) {
  EXPECT_TRUE(turn(90, 0, 0).isApprox(matrix(kY, -kX, kZ), 1e-15));
  EXPECT_TRUE(turn(0, 90, 0).isApprox(matrix(-kZ, kY, kX), 1e-15));
  EXPECT_TRUE(turn(0, 0, 90).isApprox(matrix(kX, kZ, -kY), 1e-15));
  EXPECT_TRUE(turn(90, 90, 0).isApprox(matrix(-kZ, -kX, kY), 1e-15));
  EXPECT_TRUE(turn(0, 90, 90).isApprox(matrix(-kZ, kX, -kY), 1e-15));
}

/// A spindle across the flange, as in public milling programs: TOOL {.., A 0, B 90, C 0}, and a
/// cutter that points down: {.., A -180, B 0, C -180}.
TEST(KrlAngles, PublicExamplesOfMillingProgramsPointWhereTheSpindleDoes) {
  EXPECT_TRUE(Eigen::Vector3d(turn(0, 90, 0) * kZ).isApprox(kX, 1e-15));
  EXPECT_TRUE(Eigen::Vector3d(turn(-180, 0, -180) * kZ).isApprox(-kZ, 1e-15));
  EXPECT_TRUE(Eigen::Vector3d(turn(-180, 0, -180) * kX).isApprox(-kX, 1e-15));
}

TEST(KrlAngles, ComeBackAtAndNearGimbalLock) {
  for (const double b : {90.0, -90.0, 89.9999999, -89.99999, 90.0000001, 89.9, 0.0, 180.0, 45.0})
    for (const double a : {0.0, 17.0, -123.4, 180.0})
      for (const double c : {0.0, 55.5, -179.99, 180.0}) {
        const Eigen::Isometry3d pose = krl_pose({1, -2, 3, a, b, c});
        EXPECT_TRUE(krl_pose(krl_numbers(pose)).isApprox(pose, 1e-12)) << a << " " << b << " " << c;
      }
}

TEST(KrlAngles, FiveDigitsAreWithinAThousandthOfADegreeAtGimbalLockToo) {
  for (const double b : {90.0, 89.9999, -89.99999, 12.0}) {
    const Eigen::Isometry3d pose = krl_pose({0, 0, 0, 33.333333, b, -71.7171717});
    KrlNumbers rounded = krl_numbers(pose);
    for (double& number : rounded)
      number = std::round(number * 1e5) / 1e5;
    const double off = Eigen::Quaterniond(krl_pose(rounded).linear())
                           .angularDistance(Eigen::Quaterniond(pose.linear()));
    EXPECT_LT(off * 180 / M_PI, 1e-3);
  }
}

}  // namespace
}  // namespace tool_path_programs
