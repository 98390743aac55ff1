// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "gcode_reader/gcode_axes.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

Eigen::Vector3d into_part(const std::string& dialect, double a, double b, double c) {
  GcodeAxes axes;
  axes << 0, 0, 0, a, b, c;
  return GcodeDialect(dialect).pose(axes).linear().col(2);
}

GcodeAxes back(const std::string& dialect, double a, double b, double c, const GcodeAxes& before) {
  GcodeAxes axes;
  axes << 100, -20, 3, a, b, c;
  const GcodeDialect of(dialect);
  const GcodeAxes again = of.axes(of.pose(axes), before);
  const Eigen::Isometry3d pose = of.pose(again);
  EXPECT_LT((pose.translation() - of.pose(axes).translation()).norm(), 1e-12);
  EXPECT_LT((pose.linear().col(2) - of.pose(axes).linear().col(2)).norm(), 1e-9);
  if (of.says_orientations()) {
    EXPECT_LT((pose.linear() - of.pose(axes).linear()).norm(), 1e-9) << a << " " << b << " " << c;
  }
  return again;
}

const GcodeAxes kNothing = GcodeAxes::Constant(NAN);

// Roll, pitch, yaw about fixed axes X, Y, Z, as in LinuxCNC's genserkins for A, B, C: closed forms.
TEST(GcodeAxes, OfRobotsAreRollPitchYaw) {
  const double s = std::sin(30 * M_PI / 180);
  const double c = std::cos(30 * M_PI / 180);
  EXPECT_LT((into_part("xyzabc", 30, 0, 0) - Eigen::Vector3d(0, -s, c)).norm(), 1e-12);
  EXPECT_LT((into_part("xyzabc", 0, 30, 0) - Eigen::Vector3d(s, 0, c)).norm(), 1e-12);
  EXPECT_LT((into_part("xyzabc", 0, 30, 90) - Eigen::Vector3d(0, s, c)).norm(), 1e-12);
  EXPECT_LT((into_part("xyzabc", 180, 0, 0) - Eigen::Vector3d(0, 0, -1)).norm(), 1e-12);
}

// The spindle turns about X or Y, then about Z; the tool points the other way.
TEST(GcodeAxes, OfMachinesTiltTheSpindle) {
  const double s = std::sin(30 * M_PI / 180);
  const double c = std::cos(30 * M_PI / 180);
  EXPECT_LT((into_part("xyz", 0, 0, 0) - Eigen::Vector3d(0, 0, -1)).norm(), 1e-12);
  EXPECT_LT((into_part("xyzac", 30, 0, 0) + Eigen::Vector3d(0, -s, c)).norm(), 1e-12);
  EXPECT_LT((into_part("xyzac", 30, 0, 90) + Eigen::Vector3d(s, 0, c)).norm(), 1e-12);
  EXPECT_LT((into_part("xyzbc", 0, 30, 0) + Eigen::Vector3d(s, 0, c)).norm(), 1e-12);
  EXPECT_LT((into_part("xyzbc", 0, 30, 90) + Eigen::Vector3d(0, s, c)).norm(), 1e-12);
}

TEST(GcodeAxes, ComeBackEverywhereAndAtGimbalLock) {
  for (const double tilt : {0.0, 1e-9, 1e-5, 30.0, 89.99999, 90.0, 90.00001, 179.99999, 180.0})
    for (const double sign : {-1.0, 1.0})
      for (const double turn : {-180.0, -90.0, 0.0, 33.0, 180.0}) {
        back("xyzac", sign * tilt, 0, turn, kNothing);
        back("xyzbc", 0, sign * tilt, turn, kNothing);
        for (const double roll : {-179.0, 0.0, 12.0})
          back("xyzabc", roll, sign * tilt, turn, kNothing);
      }
}

TEST(GcodeAxes, DoNotJumpByTurnsNorTurnOver) {
  GcodeAxes before;
  before << 0, 0, 0, 10, 20, 359;
  EXPECT_NEAR(back("xyzabc", 10, 20, 2, before)[5], 362, 1e-9);
  before << 0, 0, 0, -30, 0, 100;  // the same direction as A 30 C -80
  const GcodeAxes tilted = back("xyzac", 31, 0, -80, before);
  EXPECT_NEAR(tilted[3], -31, 1e-9);
  EXPECT_NEAR(tilted[5], 100, 1e-9);
  before << 0, 0, 0, 0.001, 0, 77;  // upright: C stays
  EXPECT_NEAR(back("xyzac", 0, 0, 0, before)[5], 77, 1e-9);
}

TEST(GcodeAxes, OtherDialectsAreRefused) {
  EXPECT_THROW(GcodeDialect("xyzab"), scan_cell_common::InvalidParameter);
}

}  // namespace
}  // namespace tool_path_programs
