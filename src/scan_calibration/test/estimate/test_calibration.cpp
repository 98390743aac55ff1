// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "camera_calibration.h"
#include "estimate/example_sessions.h"
#include "laser_triangulation/triangulator.h"
#include "scan_calibration/calibration.h"
#include "scan_cell_common/errors/errors.h"
#include "sequential.h"

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using scan_calibration::calibrate;
using scan_calibration::Calibration;
using scan_calibration::CalibrationOptions;
using scan_calibration::Figures;
using scan_calibration::Observations;
using synthetic::expect_true;
using synthetic::kNoise;
using synthetic::some_poses;
using synthetic::some_views;
using synthetic::spoil_corners;

TEST(Calibration, FindsTheTruthExactlyWithoutNoise) {
  const synthetic::Cell cell;
  const Calibration found = calibrate(observe(cell, some_poses(cell, 15), {}, 1), {});
  const scan_cell_common::CameraIntrinsics& camera = found.scanner.camera;
  EXPECT_NEAR(camera.fx, cell.scanner.camera.fx, 1e-5);
  EXPECT_NEAR(camera.fy, cell.scanner.camera.fy, 1e-5);
  EXPECT_NEAR(camera.cx, cell.scanner.camera.cx, 1e-5);
  EXPECT_NEAR(camera.cy, cell.scanner.camera.cy, 1e-5);
  EXPECT_LT((camera.distortion - cell.scanner.camera.distortion).norm(), 1e-7);
  EXPECT_TRUE(found.scanner.flange_to_camera.isApprox(cell.scanner.flange_to_camera, 1e-8));
  EXPECT_TRUE(found.base_to_board.isApprox(cell.base_to_board, 1e-8));
  for (std::size_t laser = 0; laser < 2; ++laser) {
    EXPECT_LT((found.scanner.laser(laser).normal - cell.scanner.laser(laser).normal).norm(), 1e-8);
    EXPECT_NEAR(found.scanner.laser(laser).distance, cell.scanner.laser(laser).distance, 1e-8);
  }
  scan_cell_common::check(found.scanner);
  EXPECT_LT(found.held_out.reprojection_rms_px, 1e-5);
  EXPECT_LT(found.held_out.board_scatter_mm, 1e-5);
  EXPECT_TRUE(found.rejected.empty());
}

TEST(Calibration, TakesTheProjectorWhereItIsKnown) {
  const synthetic::Cell cell;
  CalibrationOptions options;
  for (std::size_t laser = 0; laser < 2; ++laser)
    options.projectors.push_back(cell.scanner.laser(laser).origin);
  const Calibration found = calibrate(observe(cell, some_poses(cell, 12), {}, 1), options);
  for (std::size_t laser = 0; laser < 2; ++laser)
    EXPECT_LT((found.scanner.laser(laser).origin - cell.scanner.laser(laser).origin).norm(), 1e-6);
}

TEST(Calibration, EstimatesEachKindOfNoise) {
  const synthetic::Cell cell;
  const synthetic::Noise noise = {0.15, 0.3, 2e-4, 1e-4};
  const Calibration found = calibrate(observe(cell, some_poses(cell, 40), noise, 3), {});
  EXPECT_NEAR(found.noise.corner_px, noise.corner_px, 0.03 * noise.corner_px);
  // The line lies nearly along the columns, so the error of a peak's column is across it.
  for (const double line : found.noise.line_px)
    EXPECT_NEAR(line, noise.line_px, 0.15 * noise.line_px);
  EXPECT_NEAR(found.noise.robot_m, noise.robot_m, 0.25 * noise.robot_m);
  EXPECT_NEAR(found.noise.robot_rad, noise.robot_rad, 0.25 * noise.robot_rad);
}

TEST(Calibration, UsesTheNoiseThatIsGiven) {
  CalibrationOptions options;
  options.corner_deviation = 0.2;
  options.line_deviation = 0.4;
  options.robot_deviation = 1e-3;
  options.robot_angle_deviation = 2e-3;
  const Calibration found = calibrate(some_views(12), options);
  EXPECT_EQ(found.noise.corner_px, 0.2);
  EXPECT_EQ(found.noise.line_px[1], 0.4);
  EXPECT_EQ(found.noise.robot_m, 1e-3);
  EXPECT_EQ(found.noise.robot_rad, 2e-3);
}

TEST(Calibration, StatesDeviationsThatTheTruthKeepsTo) {
  const synthetic::Cell cell;
  constexpr int kTrials = 20;
  double squares = 0, count = 0;
  for (unsigned seed = 1; seed <= kTrials; ++seed) {
    const Calibration found = calibrate(some_views(25, seed), {});
    const std::vector<double> truth = true_parameters(cell, found);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double miss = (found.parameters[i].value - truth[i]) / found.parameters[i].deviation;
      EXPECT_LT(std::abs(miss), 4.5) << found.parameters[i].name << ", seed " << seed;
      squares += miss * miss;
      count += 1;
    }
  }
  // The stated deviations are upper bounds, from two ways of estimating them
  EXPECT_LT(std::sqrt(squares / count), 1.05);
  EXPECT_GT(std::sqrt(squares / count), 0.7);
}

TEST(Calibration, StatesForPointsOfTheScanWhatTheyAreOffBy) {
  const synthetic::Cell cell;
  double squares = 0, count = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Calibration found = calibrate(some_views(25, seed), {});
    ASSERT_EQ(found.uncertainty.size(), 30u);
    for (const scan_calibration::PointUncertainty& point : found.uncertainty) {
      const std::size_t laser = point.laser == "laser_1" ? 1 : 0;
      const auto place = [&](const scan_cell_common::ScannerModel& model) -> Vector3d {
        Vector2d ray(0, 0);
        EXPECT_TRUE(model.camera.undistort({(point.pixel.x() - model.camera.cx) / model.camera.fx,
                                            (point.pixel.y() - model.camera.cy) / model.camera.fy},
                                           ray));
        const scan_cell_common::LaserPlane& plane = model.laser(laser);
        const Vector3d direction = ray.homogeneous();
        return model.flange_to_camera *
               (direction * (plane.distance / plane.normal.dot(direction)));
      };
      const double off = 1e3 * (place(found.scanner) - place(cell.scanner)).norm();
      squares += std::pow(off / point.deviation_mm, 2);
      count += 1;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 1.3);
  EXPECT_GT(std::sqrt(squares / count), 0.4);
}

TEST(Calibration, IsTheSameToTheLastBitOnAnyNumberOfThreads) {
  const Observations observations = some_views(12);
  CalibrationOptions options;
  options.threads = 1;
  const Calibration one = calibrate(observations, options);
  options.threads = 4;
  const Calibration four = calibrate(observations, options);
  ASSERT_EQ(one.parameters.size(), four.parameters.size());
  for (std::size_t i = 0; i < one.parameters.size(); ++i) {
    EXPECT_EQ(one.parameters[i].value, four.parameters[i].value);
    EXPECT_EQ(one.parameters[i].deviation, four.parameters[i].deviation);
  }
  EXPECT_EQ(one.held_out.reprojection_rms_px, four.held_out.reprojection_rms_px);
  EXPECT_EQ(one.held_out.laser_plane_rms_mm, four.held_out.laser_plane_rms_mm);
  EXPECT_EQ(one.held_out.board_scatter_mm, four.held_out.board_scatter_mm);
}

TEST(Calibration, JudgesFiguresByTheNoiseThatIsThere) {
  const Calibration found = calibrate(some_views(40), {});
  // A corner has two coordinates, and each view's pose takes up six of 750
  EXPECT_NEAR(found.fitted.reprojection_rms_px, std::sqrt(2.) * 0.1, 0.003);
  EXPECT_NEAR(found.held_out.reprojection_rms_px, std::sqrt(2.) * 0.1, 0.003);
  EXPECT_GE(found.held_out.board_scatter_mm, found.fitted.board_scatter_mm);
  ASSERT_EQ(found.views.size(), 40u);
  EXPECT_EQ(found.views[0].corner_residuals.size(), 375u);
}

TEST(Calibration, PutsRightWhatWasCountedFromTheBoardsOtherEnd) {
  const synthetic::Cell cell;
  Observations observations = some_views(25);
  for (const std::size_t view : {2u, 3u, 17u})
    for (scan_calibration::SeenCorner& corner : observations.views[view].corners) {
      corner.column = cell.board.columns - 1 - corner.column;
      corner.row = cell.board.rows - 1 - corner.row;
    }
  const Calibration found = calibrate(observations, {});
  EXPECT_EQ(found.views.size(), 25u);
  expect_true(cell, found);
}

TEST(Calibration, SaysWhereTheLensWasNotSeen) {
  synthetic::Cell cell;
  cell.board = {9, 7, 0.02};
  synthetic::Poses poses;
  poses.count = 20;
  poses.nearest = 0.45;
  poses.farthest = 0.55;
  poses.aside = 0.02;
  const Calibration found = calibrate(observe(cell, flange_poses(cell, poses), kNoise, 1), {});
  EXPECT_TRUE(std::any_of(found.notes.begin(), found.notes.end(), [](const std::string& note) {
    return note.find("show the board further out") != std::string::npos;
  }));
}

TEST(Calibration, AdvisesAPoseThatBringsWhatItSays) {
  const synthetic::Cell cell;
  const std::vector<Isometry3d> poses = some_poses(cell, 12);
  const auto rms = [](const Calibration& found) {
    double squares = 0;
    for (const scan_calibration::PointUncertainty& point : found.uncertainty)
      squares += point.deviation_mm * point.deviation_mm;
    return std::sqrt(squares / static_cast<double>(found.uncertainty.size()));
  };
  CalibrationOptions options;  // known noise, so that the two compare
  options.corner_deviation = options.line_deviation = 0.1;
  options.robot_deviation = options.robot_angle_deviation = 5e-5;
  const Calibration before = calibrate(observe(cell, poses, {}, 1), options);
  ASSERT_FALSE(before.advice.empty());
  std::vector<Isometry3d> more = poses;
  more.push_back(before.advice.front().base_to_flange);
  const Calibration after = calibrate(observe(cell, more, {}, 1), options);
  EXPECT_EQ(after.views.size(), 13u);
  EXPECT_EQ(after.views.back().corner_residuals.size(), 375u);  // the whole board is seen
  EXPECT_NEAR(rms(after), before.advice.front().deviation_mm,
              0.15 * before.advice.front().deviation_mm);
  EXPECT_LT(rms(after), rms(before));
}

TEST(Calibration, ScansAPlaneFlat) {
  const synthetic::Cell cell;
  const Calibration found = calibrate(some_views(40), {});
  // The true laser's light on a plane at the height of the board, moved along under the scanner
  const Isometry3d& camera = cell.scanner.flange_to_camera;
  laser_triangulation::Triangulator triangulator(found.scanner, {});
  std::vector<laser_triangulation::ScanPoint> points;
  for (int step = 0; step < 50; ++step) {
    Isometry3d flange = Isometry3d::Identity();
    flange.linear() = Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).toRotationMatrix();
    flange.translation() << 0.5 + 0.005 * step, 0, 0.58;
    const Isometry3d to_camera = (flange * camera).inverse();
    const Vector3d normal = to_camera.linear() * Vector3d::UnitZ();
    const double distance = normal.dot(to_camera.translation());
    for (std::size_t laser = 0; laser < 2; ++laser) {
      std::vector<float> columns(1710, NAN), ones(1710, 1.F);
      const scan_cell_common::LaserPlane& plane = cell.scanner.laser(laser);
      Eigen::Matrix3d rows;  // the two planes and the image's row: where the light is seen
      for (std::size_t row = 100; row < 1600; row += 3) {
        double x = 0;
        Vector3d point;
        for (int i = 0; i < 50; ++i) {  // the lens bends the row
          Vector2d ray(0, 0);
          const Vector2d distorted((x) / 1., (static_cast<double>(row) - cell.scanner.camera.cy) /
                                                 cell.scanner.camera.fy);
          ASSERT_TRUE(cell.scanner.camera.undistort(distorted, ray = distorted));
          rows << plane.normal.transpose(), normal.transpose(), 0, 1, -ray.y();
          point = rows.inverse() * Vector3d(plane.distance, distance, 0);
          x = cell.scanner.camera.distort(point.head<2>() / point.z()).x();
        }
        columns[row] = static_cast<float>(cell.scanner.camera.project(point).x());
      }
      triangulator.add({laser, 0, columns.size(), columns.data(), ones.data(), ones.data()}, flange,
                       points);
    }
  }
  ASSERT_GT(points.size(), 20000u);
  double squares = 0;
  for (const laser_triangulation::ScanPoint& point : points)
    squares += double{point.z} * point.z;
  EXPECT_LT(std::sqrt(squares / static_cast<double>(points.size())), 1e-4);
}

TEST(Calibration, IsNoWorseThanOneStepAfterTheOther) {
  const Observations observations = some_views(20);
  const Calibration joint = calibrate(observations, {});
  const scan_calibration::SequentialCalibration steps =
      calibrate_sequentially(used_views(observations, joint), 5);
  EXPECT_LT(joint.held_out.reprojection_rms_px, 1.01 * steps.held_out.reprojection_rms_px);
  EXPECT_LT(joint.held_out.laser_plane_rms_mm[0], 1.02 * steps.held_out.laser_plane_rms_mm[0]);
  EXPECT_LT(joint.held_out.board_scatter_mm, 1.02 * steps.held_out.board_scatter_mm);
}

TEST(Calibration, RefusesOptionsThatMakeNoSense) {
  CalibrationOptions options;
  options.folds = 1;
  EXPECT_THROW(calibrate(some_views(6), options), scan_cell_common::InvalidParameter);
  options = {};
  options.robot_deviation = -1;
  EXPECT_THROW(calibrate(some_views(6), options), scan_cell_common::InvalidParameter);
}

TEST(CameraCalibration, FindsTheCameraAndTheBadViewWithoutTheRobot) {
  const synthetic::Cell cell;
  Observations observations = some_views(15);
  spoil_corners(observations.views[3]);
  for (scan_calibration::ViewObservation& view : observations.views)
    view.base_to_flange = Isometry3d::Identity();
  const scan_calibration::CameraCalibration found = calibrate_camera(observations, {});
  ASSERT_EQ(found.rejected.size(), 1u);
  EXPECT_EQ(found.rejected[0].name, "view3");
  EXPECT_NEAR(found.reprojection_rms_px, std::sqrt(2.) * 0.1, 0.003);
  const double truth[] = {cell.scanner.camera.fx, cell.scanner.camera.fy, cell.scanner.camera.cx,
                          cell.scanner.camera.cy};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(found.parameters[i].value, truth[i], 4 * found.parameters[i].deviation)
        << found.parameters[i].name;
}
