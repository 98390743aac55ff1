// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "calibration/calibrating_cell.h"

TEST_F(Calibration, FindsALaserAgainThatTheModelHasWrongAndKeepsTheRest) {
  ScannerModel old = scan_cell_common::load_scanner_model(config("calibrated_scanner.yaml"));
  LaserPlane& wrong = *old.lasers[1];
  wrong.normal = Eigen::AngleAxisd(0.03, Eigen::Vector3d::UnitY()) * wrong.normal;
  wrong.distance = wrong.normal.dot(wrong.origin);
  CalibrateGoal wanted = goal("tilted", some_poses(4));
  wanted.lasers = 2;
  wanted.lasers_alone = 1;
  wanted.scanner = wanted.output = folder_ + "/scanner.yaml";
  scan_cell_common::save_scanner_model(wanted.scanner, old);
  old = scan_cell_common::load_scanner_model(wanted.scanner);
  client_.sendGoal(wanted);
  const CalibrateResult result = end();
  ASSERT_EQ(result.outcome, CalibrateResult::FINISHED) << result.message;
  EXPECT_EQ(result.kept, (std::vector<std::string>{"camera", "flange_to_camera", "laser_0"}));
  const ScannerModel model = scan_cell_common::load_scanner_model(result.model);
  EXPECT_EQ(model.camera.fx, old.camera.fx);
  EXPECT_EQ(model.flange_to_camera.matrix(), old.flange_to_camera.matrix());
  EXPECT_EQ(model.laser(0).normal, old.laser(0).normal);
  const ScannerModel truth = scan_cell_common::load_scanner_model(config("scanner.yaml"));
  EXPECT_GT(worst_point(old, truth), 0.001);
  EXPECT_LT(worst_point(model, truth), 0.0002);
  EXPECT_TRUE(std::all_of(lit_.begin(), lit_.end(), [](int mask) { return mask == 2; }));
}

TEST_F(Calibration, FindsTheCameraAloneWithoutALaser) {
  CalibrateGoal wanted = goal("camera", some_poses(2));
  wanted.lasers = 0;
  wanted.scanner = config("calibrated_scanner.yaml");
  wanted.output = folder_ + "/scanner.yaml";
  client_.sendGoal(wanted);
  const CalibrateResult result = end();
  ASSERT_EQ(result.outcome, CalibrateResult::FINISHED) << result.message;
  EXPECT_EQ(result.kept, (std::vector<std::string>{"laser_0", "laser_1"}));
  const ScannerModel model = scan_cell_common::load_scanner_model(result.model);
  const ScannerModel old = scan_cell_common::load_scanner_model(wanted.scanner);
  EXPECT_NE(model.camera.fx, old.camera.fx);
  EXPECT_EQ(model.laser(1).distance, old.laser(1).distance);
  expect_within_stated_bounds(result.report,
                              scan_cell_common::load_scanner_model(config("scanner.yaml")));
  EXPECT_TRUE(lit_.empty()) << "a laser was on";
}
