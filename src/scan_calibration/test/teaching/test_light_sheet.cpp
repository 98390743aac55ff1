// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "teaching/calibrated_frames.h"
#include "teaching/light_sheet.h"

using Eigen::Vector3d;
using scan_calibration::BurningLasers;
using scan_cell_common::LaserPlane;

namespace {

constexpr double kRate = 100;  // [Hz]

/// A projector 0.25 m left of the camera and 20 mm above its axis; the plane crosses the axis 0.5 m
/// in front of it.
LaserPlane left_laser_above_the_axis() {
  LaserPlane laser;
  laser.origin << -0.25, 0.02, 0;
  laser.normal = Vector3d(2, 0, -1).normalized();
  laser.distance = laser.normal.dot(laser.origin);
  return laser;
}

}  // namespace

TEST(LightSheet, LiesInThePlaneFromTheProjectorToTheOpticalAxis) {
  const LaserPlane laser = left_laser_above_the_axis();
  const Eigen::Isometry3d frame = scan_calibration::laser_frame(laser, "laser_0");
  const auto sheet = scan_calibration::light_sheet(laser, "laser_0", {M_PI / 3, 0});
  for (const Vector3d& corner : sheet)
    EXPECT_NEAR(laser.normal.dot(frame * corner), laser.distance, 1e-12);
  EXPECT_TRUE((frame * sheet[0]).isApprox(laser.origin, 1e-12));
  const Vector3d middle = (sheet[1] + sheet[2]) / 2;
  EXPECT_TRUE((frame * middle).isApprox(Vector3d(0, 0, 0.5), 1e-12));
  const Vector3d one = (sheet[1] - sheet[0]).normalized(),
                 other = (sheet[2] - sheet[0]).normalized();
  EXPECT_NEAR(std::acos(one.dot(other)), M_PI / 3, 1e-12);
}

TEST(LightSheet, IsAsLongAsAsked) {
  const auto sheet =
      scan_calibration::light_sheet(left_laser_above_the_axis(), "laser_0", {M_PI / 2, 0.3});
  EXPECT_TRUE(sheet[1].isApprox(Vector3d(0, -0.3, 0.3), 1e-12));
  EXPECT_TRUE(sheet[2].isApprox(Vector3d(0, 0.3, 0.3), 1e-12));
}

TEST(BurningLasers, AreThoseThatTheStateNamesWhileItsPulsesCome) {
  BurningLasers burning;
  EXPECT_FALSE(burning.burns(0, 0));
  burning.on_state(true, 1, kRate, 10);
  EXPECT_TRUE(burning.burns(0, 10.4));
  EXPECT_FALSE(burning.burns(1, 10.4));
  burning.on_pulse(1, 10.4);
  EXPECT_TRUE(burning.burns(0, 10.8));
  EXPECT_FALSE(burning.burns(0, 11));  // no pulse came
}

TEST(BurningLasers, AreOffAsSoonAsTheStateSaysSoThoughLatePulsesCome) {
  BurningLasers burning;
  burning.on_state(true, 3, kRate, 10);
  burning.on_state(false, 0, 0, 10.1);
  burning.on_pulse(3, 10.11);
  EXPECT_FALSE(burning.burns(0, 10.12));
  EXPECT_FALSE(burning.burns(1, 10.12));
}

TEST(BurningLasers, BothBurnWhileTheyTakeTurns) {
  BurningLasers burning;
  constexpr double kSlow = 0.5;  // [Hz]
  burning.on_state(true, 3, kSlow, 10);
  for (int pulse = 1; pulse <= 4; ++pulse) {
    const double now = 10 + 2 * pulse / kSlow;
    EXPECT_TRUE(burning.burns(0, now));
    EXPECT_TRUE(burning.burns(1, now));
    burning.on_pulse(pulse % 2 == 1 ? 1 : 2, now);
  }
}

TEST(BurningLasers, AreToldByPulsesAloneInABag) {
  BurningLasers burning;
  burning.on_pulse(2, 10);
  EXPECT_FALSE(burning.burns(0, 10.1));
  EXPECT_TRUE(burning.burns(1, 10.1));
  EXPECT_FALSE(burning.burns(1, 11));
}
