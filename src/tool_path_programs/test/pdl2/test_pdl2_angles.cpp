// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "pdl2_reader/pdl2_conventions.h"

namespace tool_path_programs {
namespace {

Eigen::Matrix3d turn(double a, double e, double r) {
  return pdl2_pose({0, 0, 0, a, e, r}).linear();
}

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();
const Eigen::Vector3d kY = Eigen::Vector3d::UnitY();
const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();

Eigen::Matrix3d matrix(const Eigen::Vector3d& x, const Eigen::Vector3d& y,
                       const Eigen::Vector3d& z) {
  return (Eigen::Matrix3d() << x, y, z).finished();
}

/// Comau's motion programming manual, Euler angles: A about Z, E about the new Y, R about the new
/// Z.
TEST(Pdl2Angles, AreAboutZThenYThenZEachTurnedByTheOnesBefore) {
  EXPECT_TRUE(turn(90, 0, 0).isApprox(matrix(kY, -kX, kZ), 1e-15));
  EXPECT_TRUE(turn(0, 90, 0).isApprox(matrix(-kZ, kY, kX), 1e-15));
  EXPECT_TRUE(turn(0, 0, 90).isApprox(matrix(kY, -kX, kZ), 1e-15));
  EXPECT_TRUE(turn(90, 90, 0).isApprox(matrix(-kZ, -kX, kY), 1e-15));
  EXPECT_TRUE(turn(0, 90, 90).isApprox(matrix(kY, kZ, kX), 1e-15));
}

/// A tool that points down, as in public programs for printing and milling: 0, 180, 0.
TEST(Pdl2Angles, PublicExamplesOfToolsThatPointDown) {
  EXPECT_TRUE(turn(0, 180, 0).isApprox(matrix(-kX, kY, -kZ), 1e-15));
  EXPECT_TRUE(turn(0, 180, 90).isApprox(turn(-90, 180, 0), 1e-15));
}

TEST(Pdl2Angles, ComeBackAtAndNearGimbalLock) {
  for (const double e : {0.0, 1e-7, 1e-4, 180.0, 179.9999999, 180.0001, -1e-5, 90.0, 45.0})
    for (const double a : {0.0, 17.0, -123.4, 180.0})
      for (const double r : {0.0, 55.5, -179.99, 180.0}) {
        const Eigen::Isometry3d pose = pdl2_pose({1, -2, 3, a, e, r});
        EXPECT_TRUE(pdl2_pose(pdl2_numbers(pose)).isApprox(pose, 1e-12)) << a << " " << e;
        Pdl2Numbers rounded = pdl2_numbers(pose);
        for (double& number : rounded)
          number = std::round(number * 1e5) / 1e5;
        const double off = Eigen::Quaterniond(pdl2_pose(rounded).linear())
                               .angularDistance(Eigen::Quaterniond(pose.linear()));
        EXPECT_LT(off * 180 / M_PI, 1e-3);
      }
}

}  // namespace
}  // namespace tool_path_programs
