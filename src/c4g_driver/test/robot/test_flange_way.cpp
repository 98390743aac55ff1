// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "c4g_driver/flange_way.h"
#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Isometry3d flange_at(double x, double y, double angle = 0) {
  return Eigen::Translation3d(x, y, 1) * Eigen::AngleAxisd(angle, Vector3d::UnitZ());
}

TEST(FlangeWay, OfALineStaysOnItFromEndToEnd) {
  const auto poses = flange_way(flange_at(0, 0), std::nullopt, flange_at(0.3, 0, 0.6));
  ASSERT_GE(poses.size(), 61U);
  EXPECT_TRUE(poses.front().isApprox(flange_at(0, 0)));
  EXPECT_TRUE(poses.back().isApprox(flange_at(0.3, 0, 0.6)));
  for (const Isometry3d& pose : poses) {
    const double x = pose.translation().x();
    EXPECT_TRUE(pose.isApprox(flange_at(x, 0, 2 * x), 1e-9));
  }
}

TEST(FlangeWay, OfAnArcStaysOnItsCircle) {
  const auto poses =
      flange_way(flange_at(0.2, 0), flange_at(0, 0.2, M_PI / 2), flange_at(-0.2, 0, M_PI));
  ASSERT_GE(poses.size(), 100U);
  for (const Isometry3d& pose : poses) {
    EXPECT_NEAR((pose.translation() - Vector3d(0, 0, 1)).norm(), 0.2, 1e-9);
    const double angle = std::atan2(pose.translation().y(), pose.translation().x());
    EXPECT_TRUE(
        pose.isApprox(flange_at(0.2 * std::cos(angle), 0.2 * std::sin(angle), angle), 1e-9));
  }
}

TEST(FlangeWay, RefusesAnArcWithoutACircle) {
  EXPECT_THROW(flange_way(flange_at(0, 0), flange_at(0.1, 0), flange_at(0.2, 0)),
               scan_cell_common::Refused);
}

}  // namespace
}  // namespace c4g_driver
