// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "signs/signs.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::RobotStatus;

RobotStatus ready_robot() {
  RobotStatus robot;
  robot.connected = 1;
  robot.e_stopped = RobotStatus::NO;
  robot.drives_powered = robot.motion_possible = RobotStatus::YES;
  return robot;
}

TEST(Signs, OfTheRobotTellTheWorstFirst) {
  RobotStatus robot = ready_robot();
  EXPECT_EQ(sign_of(robot), (Sign{Level::kGood, "ready"}));
  robot.in_motion = RobotStatus::YES;
  EXPECT_EQ(sign_of(robot).text, "moving");
  robot.motion_possible = RobotStatus::NO;
  robot.controller_mode = "programming";
  EXPECT_EQ(sign_of(robot), (Sign{Level::kNotice, "accepts no motion: mode programming"}));
  robot.drives_powered = RobotStatus::NO;
  EXPECT_EQ(sign_of(robot).text, "drives are off");
  robot.alarm_texts = {"axis 3: following error", "other"};
  EXPECT_EQ(sign_of(robot), (Sign{Level::kBad, "alarm: axis 3: following error"}));
  robot.e_stopped = RobotStatus::YES;
  EXPECT_EQ(sign_of(robot), (Sign{Level::kBad, "emergency stop"}));
  robot.connected = 0;
  robot.message = "no packet for 1 s";
  EXPECT_EQ(sign_of(robot).text, "no link to the controller: no packet for 1 s");
}

TEST(Signs, OfTheLasersNameEachThatIsOn) {
  scan_cell_msgs::TriggerState trigger;
  EXPECT_EQ(sign_of(trigger), (Sign{Level::kGood, "off"}));
  trigger.armed = 1;
  EXPECT_EQ(sign_of(trigger), (Sign{Level::kNotice, "armed"}));
  trigger.lasers = 3;
  EXPECT_EQ(sign_of(trigger), (Sign{Level::kLaser, "ON: 0 1"}));
  trigger.armed = 0;
  EXPECT_EQ(sign_of(trigger).level, Level::kLaser) << "one is on whatever else is said";
}

TEST(Signs, OfACameraAndACellThatFailGiveTheirReason) {
  diagnostic_msgs::DiagnosticStatus camera;
  camera.message = "relief only";
  EXPECT_EQ(sign_of(camera), (Sign{Level::kGood, "relief only"}));
  camera.level = diagnostic_msgs::DiagnosticStatus::WARN;
  EXPECT_EQ(sign_of(camera).level, Level::kNotice);
  camera.level = diagnostic_msgs::DiagnosticStatus::STALE;
  EXPECT_EQ(sign_of(camera).level, Level::kBad);
  scan_cell_msgs::CellState cell;
  cell.state = scan_cell_msgs::CellState::FAILED;
  cell.message = "camera: no profile";
  EXPECT_EQ(sign_of(cell), (Sign{Level::kNotice, "camera: no profile"}));
}

TEST(Signs, OfTheCalibrationTellFileHashAndAge) {
  EXPECT_EQ(calibration_sign("/data/scanner.yaml", "0123456789abcdef", 3 * 86400 + 5).text,
            "scanner.yaml 01234567, 3 days");
  EXPECT_EQ(calibration_sign("/data/scanner.yaml", "0123456789abcdef", 86400 + 5).text,
            "scanner.yaml 01234567, 1 day");
  EXPECT_EQ(age_text(0), "0 days");
  EXPECT_EQ(calibration_sign("/data/scanner.yaml", "", 0).level, Level::kNotice);
  EXPECT_EQ(calibration_sign("", "", 0).level, Level::kBad);
}

}  // namespace
}  // namespace scan_cell_rviz
