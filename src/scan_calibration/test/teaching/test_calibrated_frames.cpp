// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "teaching/calibrated_frames.h"

using Eigen::Isometry3d;
using Eigen::Vector3d;
using scan_calibration::laser_frame;
using scan_cell_common::LaserPlane;

namespace {

/// A projector 0.25 m left of the camera whose plane crosses the axis 0.5 m in front of it.
LaserPlane left_laser() {
  LaserPlane laser;
  laser.origin << -0.25, 0, 0;
  laser.normal = Vector3d(2, 0, -1).normalized();
  laser.distance = laser.normal.dot(laser.origin);
  return laser;
}

std::string refused(const LaserPlane& laser) {
  try {
    laser_frame(laser, "laser_0");
  } catch (const scan_cell_common::UnusableInput& error) {
    return error.thing();
  }
  return "nothing";
}

}  // namespace

TEST(LaserFrame, LooksAlongTheLightWithThePlaneAcrossX) {
  const Isometry3d frame = laser_frame(left_laser(), "laser_0");
  EXPECT_EQ(frame.translation(), Vector3d(-0.25, 0, 0));
  EXPECT_TRUE(frame.linear().col(2).isApprox(Vector3d(1, 0, 2).normalized(), 1e-12));
  EXPECT_TRUE(frame.linear().col(0).isApprox(left_laser().normal, 1e-12));
  EXPECT_NEAR(frame.linear().determinant(), 1, 1e-12);
  const Vector3d crossing = frame.inverse() * Vector3d(0, 0, 0.5);
  EXPECT_TRUE(crossing.isApprox(Vector3d(0, 0, std::hypot(0.25, 0.5)), 1e-12));
}

TEST(LaserFrame, IsRefusedByTheLasersNameWhereItsPlaneMissesTheAxis) {
  LaserPlane along_axis = left_laser();
  along_axis.normal = Vector3d::UnitX();
  along_axis.distance = -0.25;
  EXPECT_EQ(refused(along_axis), "scanner model: laser_0");
  LaserPlane behind = left_laser();
  behind.normal = Vector3d(2, 0, 1).normalized();
  behind.distance = behind.normal.dot(behind.origin);
  EXPECT_EQ(refused(behind), "scanner model: laser_0");
}

TEST(CalibratedFrames, HangTogetherAsTheCellDoes) {
  scan_cell_common::ScannerModel scanner;
  scanner.flange_to_camera = Isometry3d(Eigen::Translation3d(0, 0, 0.1));
  scanner.lasers = {left_laser(), left_laser()};
  scan_calibration::Cell cell;
  cell.base_link_in_world = Isometry3d(Eigen::Translation3d(-0.8, 0, 0));
  cell.tool_tip_in_tool0 = Isometry3d(Eigen::Translation3d(0, 0, 0.2));
  const auto frames = scan_calibration::calibrated_frames(scanner, cell);
  std::vector<std::string> links;
  for (const scan_calibration::StaticFrame& frame : frames)
    links.push_back(frame.parent + " -> " + frame.child);
  EXPECT_EQ(links, (std::vector<std::string>{
                       "world -> base_link", "tool0 -> tool_tip", "tool0 -> camera_optical_frame",
                       "camera_optical_frame -> laser_0", "camera_optical_frame -> laser_1"}));
  EXPECT_EQ(frames[0].pose.translation().x(), -0.8);
  EXPECT_EQ(frames[1].pose.translation().z(), 0.2);
  EXPECT_EQ(frames[2].pose.translation().z(), 0.1);
}
