// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "estimate/example_sessions.h"
#include "scan_calibration/calibration.h"
#include "scan_cell_common/errors/errors.h"
#include "sequential.h"

using Eigen::Vector3d;
using scan_calibration::calibrate;
using scan_calibration::Calibration;
using scan_calibration::CalibrationOptions;
using scan_calibration::Observations;
using scan_cell_common::LaserPlane;
using scan_cell_common::ScannerModel;
using synthetic::kNoise;
using synthetic::some_poses;
using Names = std::vector<std::string>;

namespace {

/// The observations without those of the other lasers.
Observations only(Observations observations, const Names& lasers) {
  for (scan_calibration::ViewObservation& view : observations.views) {
    const auto lines = view.lines;
    view.lines.clear();
    for (const std::string& laser : lasers)
      view.lines.push_back(lines[scan_cell_common::laser_index(laser)]);
  }
  observations.lasers = lasers;
  return observations;
}

CalibrationOptions keeping(const ScannerModel& model, bool lasers_alone) {
  CalibrationOptions options;
  options.existing = scan_calibration::ExistingScanner{"old.yaml", "", model};
  options.lasers_alone = lasers_alone;
  return options;
}

/// A cell whose second laser was tilted by 3 degrees after the model was made.
synthetic::Cell tilted() {
  synthetic::Cell cell;
  LaserPlane& laser = *cell.scanner.lasers[1];
  laser.normal = Eigen::AngleAxisd(0.05, Vector3d(0.3, 1, 0.2).normalized()) * laser.normal;
  laser.distance = laser.normal.dot(laser.origin);
  return cell;
}

/// The old model: of the cell before the change, slightly wrong, as models are.
ScannerModel old_model() {
  ScannerModel model = synthetic::Cell().scanner;
  model.camera.fx += 0.02;
  model.camera.distortion[0] += 1e-5;
  model.flange_to_camera.translate(Vector3d(2e-5, -1e-5, 1e-5));
  return model;
}

void expect_same(const LaserPlane& one, const LaserPlane& other) {
  EXPECT_EQ(one.normal, other.normal);
  EXPECT_EQ(one.distance, other.distance);
  EXPECT_EQ(one.origin, other.origin);
}

void expect_same_camera(const ScannerModel& one, const ScannerModel& other) {
  EXPECT_EQ(one.camera.fx, other.camera.fx);
  EXPECT_EQ(one.camera.fy, other.camera.fy);
  EXPECT_EQ(one.camera.cx, other.camera.cx);
  EXPECT_EQ(one.camera.cy, other.camera.cy);
  EXPECT_EQ(one.camera.distortion, other.camera.distortion);
  EXPECT_EQ(one.flange_to_camera.matrix(), other.flange_to_camera.matrix());
}

bool has_parameter(const Calibration& found, const std::string& part) {
  return std::any_of(found.parameters.begin(), found.parameters.end(),
                     [&](const auto& parameter) { return parameter.name.find(part) == 0; });
}

bool has_note(const Calibration& found, const std::string& part) {
  return std::any_of(found.notes.begin(), found.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

std::string refusal(const Observations& observations, const CalibrationOptions& options) {
  try {
    calibrate(observations, options);
  } catch (const scan_cell_common::Error& error) {
    return error.what();
  }
  return "";
}

void expect_in(const std::string& part, const std::string& text) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

}  // namespace

TEST(PartialCalibration, FindsTheSecondLaserAlone) {
  const synthetic::Cell cell;
  const Observations seen = only(observe(cell, some_poses(cell, 12), {}, 1), {"laser_1"});
  const Calibration found = calibrate(seen, {});
  ASSERT_EQ(found.scanner.lasers.size(), 2U);
  EXPECT_FALSE(found.scanner.has_laser(0));
  EXPECT_LT((found.scanner.laser(1).normal - cell.scanner.laser(1).normal).norm(), 1e-8);
  EXPECT_NEAR(found.scanner.laser(1).distance, cell.scanner.laser(1).distance, 1e-8);
  EXPECT_NEAR(found.scanner.camera.fx, cell.scanner.camera.fx, 1e-5);
  EXPECT_TRUE(has_parameter(found, "lasers[1].distance"));
  EXPECT_FALSE(has_parameter(found, "lasers[0]"));
  EXPECT_TRUE(found.kept.empty());
  ASSERT_FALSE(found.uncertainty.empty());
  EXPECT_EQ(found.uncertainty[0].laser, "laser_1");
  check(found.scanner);
}

TEST(PartialCalibration, KeepsTheOtherLasersPlaneBitByBit) {
  const synthetic::Cell cell = tilted();
  const ScannerModel old = old_model();
  const Observations seen = only(observe(cell, some_poses(cell, 15), kNoise, 2), {"laser_1"});
  const Calibration found = calibrate(seen, keeping(old, false));
  expect_same(found.scanner.laser(0), old.laser(0));
  EXPECT_LT((found.scanner.laser(1).normal - cell.scanner.laser(1).normal).norm(), 1e-3);
  EXPECT_NE(found.scanner.camera.fx, old.camera.fx);
  EXPECT_EQ(found.kept, Names{"laser_0"});
  EXPECT_TRUE(has_note(found, "laser_0 is kept from old.yaml")) << "what it must still be fixed to";
}

TEST(PartialCalibration, FindsTheCameraAloneAndKeepsThePlanesBitByBit) {
  const synthetic::Cell cell;
  const ScannerModel old = old_model();
  const Observations seen = only(observe(cell, some_poses(cell, 15), {}, 3), {});
  const Calibration found = calibrate(seen, keeping(old, false));
  EXPECT_NEAR(found.scanner.camera.fx, cell.scanner.camera.fx, 1e-5);
  EXPECT_TRUE(found.scanner.flange_to_camera.isApprox(cell.scanner.flange_to_camera, 1e-8));
  for (std::size_t laser = 0; laser < 2; ++laser)
    expect_same(found.scanner.laser(laser), old.laser(laser));
  EXPECT_EQ(found.kept, (Names{"laser_0", "laser_1"}));
  EXPECT_TRUE(found.uncertainty.empty());
  EXPECT_TRUE(found.held_out.laser_plane_rms_mm.empty());
}

TEST(PartialCalibration, FindsTheCameraOfABareBracket) {
  const synthetic::Cell cell;
  const Observations seen = only(observe(cell, some_poses(cell, 15), kNoise, 4), {});
  const Calibration found = calibrate(seen, {});
  EXPECT_TRUE(found.scanner.lasers.empty());
  EXPECT_TRUE(has_note(found, "cannot be used for scanning"));
  synthetic::Cell bare = cell;
  bare.scanner.lasers.clear();
  synthetic::expect_true(bare, found);
}

TEST(PartialCalibration, FindsATiltedLaserExactlyAndKeepsTheCameraBitByBit) {
  const synthetic::Cell cell = tilted();
  ScannerModel old = synthetic::Cell().scanner;  // camera and place on the flange are still true
  const Observations seen = only(observe(cell, some_poses(cell, 8), {}, 5), {"laser_1"});
  const Calibration found = calibrate(seen, keeping(old, true));
  expect_same_camera(found.scanner, old);
  expect_same(found.scanner.laser(0), old.laser(0));
  EXPECT_LT((found.scanner.laser(1).normal - cell.scanner.laser(1).normal).norm(), 1e-7);
  EXPECT_NEAR(found.scanner.laser(1).distance, cell.scanner.laser(1).distance, 1e-7);
  EXPECT_EQ(found.kept, (Names{"camera", "flange_to_camera", "laser_0"}));
  EXPECT_FALSE(has_parameter(found, "camera"));
  EXPECT_FALSE(has_parameter(found, "flange_to_camera"));
  EXPECT_TRUE(has_note(found, "kept from old.yaml: corners miss it by"));
  EXPECT_TRUE(has_note(found, "those of the planes alone"));
  EXPECT_TRUE(found.base_to_board.isApprox(cell.base_to_board, 1e-6));
}

TEST(PartialCalibration, StatesDeviationsOfTheTiltedPlanesThatTheTruthKeepsTo) {
  constexpr unsigned kTrials = 12;
  const ScannerModel old = synthetic::Cell().scanner;
  double squares = 0, count = 0;
  for (unsigned seed = 1; seed <= kTrials; ++seed) {
    const synthetic::Cell cell = tilted();
    const Calibration found =
        calibrate(observe(cell, some_poses(cell, 15, seed), kNoise, seed), keeping(old, true));
    expect_same_camera(found.scanner, old);
    for (const scan_calibration::EstimatedParameter& parameter : found.parameters) {
      const auto bracket = parameter.name.find("].distance");
      if (bracket == std::string::npos) continue;
      const LaserPlane& truth = cell.scanner.laser(parameter.name[bracket - 1] - '0');
      const double miss = (parameter.value - truth.distance) / parameter.deviation;
      EXPECT_LT(std::abs(miss), 4.5) << parameter.name << ", seed " << seed;
      squares += miss * miss;
      count += 1;
    }
  }
  EXPECT_EQ(count, 2 * kTrials);
  EXPECT_LT(std::sqrt(squares / count), 1.3);
  EXPECT_GT(std::sqrt(squares / count), 0.4);
}

TEST(PartialCalibration, NeedsNoSecondAxisForLasersAlone) {
  const synthetic::Cell cell = tilted();
  synthetic::Poses poses;
  poses.count = 8;
  poses.max_tilt = 0;  // the flange turns about the camera's axis only
  const Observations seen = observe(cell, flange_poses(cell, poses), kNoise, 6);
  EXPECT_FALSE(refusal(seen, {}).empty()) << "a camera cannot be found from these";
  const Calibration found = calibrate(seen, keeping(synthetic::Cell().scanner, true));
  EXPECT_LT((found.scanner.laser(1).normal - cell.scanner.laser(1).normal).norm(), 1e-3);
}

TEST(PartialCalibration, LeavesOutAViewWhosePoseIsWrongWithTheCameraKept) {
  const synthetic::Cell cell = tilted();
  Observations seen = observe(cell, some_poses(cell, 12), kNoise, 7);
  seen.views[4].base_to_flange.pretranslate(Vector3d(0.02, 0, 0));
  const Calibration found = calibrate(seen, keeping(synthetic::Cell().scanner, true));
  ASSERT_EQ(found.rejected.size(), 1U);
  EXPECT_EQ(found.rejected[0].name, seen.views[4].name);
}

TEST(PartialCalibration, RefusesAKeptCameraWhoseLensWasFocusedAnew) {
  const synthetic::Cell cell = tilted();
  ScannerModel old = synthetic::Cell().scanner;
  old.camera.fx *= 1.05;
  old.camera.fy *= 1.05;
  const std::string text =
      refusal(observe(cell, some_poses(cell, 12), kNoise, 8), keeping(old, true));
  expect_in("camera of old.yaml: corners miss it by", text);
  expect_in("calibrate the camera too", text);
}

TEST(PartialCalibration, RefusesAKeptCameraThatWasMovedOnTheFlange) {
  const synthetic::Cell cell = tilted();
  for (const double shift : {0.002, 0.2}) {
    ScannerModel old = synthetic::Cell().scanner;
    old.flange_to_camera.translation().x() += shift;
    const std::string text =
        refusal(observe(cell, some_poses(cell, 12), kNoise, 9), keeping(old, true));
    expect_in("flange_to_camera of old.yaml", text);
    expect_in("moved on the flange", text);
  }
}

TEST(PartialCalibration, NamesAWrongBoardBeforeItBlamesTheKeptCamera) {
  const synthetic::Cell cell = tilted();
  Observations seen = observe(cell, some_poses(cell, 12), kNoise, 10);
  seen.board.square_size = 0.025;
  expect_in("board square size", refusal(seen, keeping(synthetic::Cell().scanner, true)));
}

TEST(PartialCalibration, RefusesWhatCannotBeKeptByName) {
  const Observations seen = synthetic::some_views(8);
  CalibrationOptions none;
  none.lasers_alone = true;
  expect_in("lasers_alone: no existing scanner model", refusal(seen, none));
  const ScannerModel old = old_model();
  expect_in("lasers_alone: no laser to calibrate", refusal(only(seen, {}), keeping(old, true)));
  ScannerModel other = old;
  other.camera.width = 1280;
  expect_in("camera of old.yaml: 1280 x 1710 pixels", refusal(seen, keeping(other, true)));
  Observations misnamed = seen;
  misnamed.lasers[1] = "laser_b";
  expect_in("laser_b", refusal(misnamed, {}));
}

TEST(PartialCalibration, TakesTheProjectorOfTheOldModelWhereNoneIsGiven) {
  const synthetic::Cell cell = tilted();  // it turned about its projector
  const Calibration found = calibrate(observe(cell, some_poses(cell, 8), {}, 11),
                                      keeping(synthetic::Cell().scanner, true));
  EXPECT_LT((found.scanner.laser(1).origin - cell.scanner.laser(1).origin).norm(), 1e-6);
}

TEST(SequentialCalibration, TakesTheKnownCameraAsItIs) {
  const synthetic::Cell cell = tilted();
  const ScannerModel old = synthetic::Cell().scanner;
  const auto found =
      calibrate_sequentially(only(observe(cell, some_poses(cell, 8), {}, 12), {"laser_1"}), 4, old);
  expect_same_camera(found.scanner, old);
  EXPECT_LT((found.scanner.laser(1).normal - cell.scanner.laser(1).normal).norm(), 1e-4);
  EXPECT_LT(found.held_out.laser_plane_rms_mm.at(0), 0.01);
}
