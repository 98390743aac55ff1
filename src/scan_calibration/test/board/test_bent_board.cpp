// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "estimate/example_sessions.h"
#include "scan_calibration/calibration.h"

using Eigen::Vector3d;
using scan_calibration::calibrate;
using scan_calibration::Calibration;
using scan_calibration::CalibrationOptions;
using scan_calibration::Observations;
using synthetic::expect_true;
using synthetic::kNoise;
using synthetic::some_poses;
using synthetic::some_views;

TEST(Calibration, FindsABentBoard) {
  synthetic::Cell cell;
  cell.bend = Vector3d(8e-4, -3e-4, 4e-4);
  const Observations observations = observe(cell, some_poses(cell, 30), kNoise, 1);
  CalibrationOptions options;
  options.board_flatness = false;
  const Calibration flat = calibrate(observations, options);
  options.board_flatness = true;
  const Calibration bent = calibrate(observations, options);
  EXPECT_LT((bent.board_bend - cell.bend).norm(), 2e-5);
  EXPECT_LT(bent.held_out.reprojection_rms_px, 0.9 * flat.held_out.reprojection_rms_px);
  expect_true(cell, bent);
}

TEST(Calibration, DoesNotBlameTheRobotForASmallBoardThatIsBent) {
  synthetic::Cell cell;
  cell.board = {7, 6, 0.01};
  cell.bend = Vector3d(-3e-5, -3.5e-4, -2.4e-4);
  for (unsigned seed = 1; seed <= 4; ++seed) {
    synthetic::Poses poses;
    poses.count = 16;
    poses.nearest = 0.15;
    poses.farthest = 0.25;
    poses.aside = 0.03;
    poses.seed = seed;
    Observations observations = observe(cell, flange_poses(cell, poses), kNoise, seed);
    observations.lasers.clear();  // their lines miss so small a board
    for (scan_calibration::ViewObservation& view : observations.views)
      view.lines.clear();
    for (const bool bent : {false, true}) {
      CalibrationOptions options;
      options.board_flatness = bent;
      const Calibration found = calibrate(observations, options);
      EXPECT_LT(found.noise.robot_m, 3e-4) << seed;
      EXPECT_LT(found.noise.robot_rad, 1e-3) << seed;
    }
  }
}

TEST(Calibration, TakesAFlatBoardAsFlat) {
  CalibrationOptions options;
  options.board_flatness = true;
  const Calibration found = calibrate(some_views(20), options);
  EXPECT_TRUE(found.board_bend.isZero(0));
  EXPECT_TRUE(std::any_of(found.notes.begin(), found.notes.end(), [](const std::string& note) {
    return note.find("the board is taken as flat") != std::string::npos;
  }));
}
