// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fake_scan_cell.h"

using scan_cell::Motion;
using scan_cell::Outcome;
using ScannedCell = scan_sequence_test::FakeCell;
using scan_sequence_test::ScanSequence;

TEST_F(ScanSequence, DoesTheEightStepsInTheirOrder) {
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kFinished) << end.message;
  EXPECT_EQ(observer_.steps, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
  std::vector<std::string> once = cell_.log;
  once.erase(std::remove(once.begin(), once.end(), "keep alive"), once.end());
  EXPECT_EQ(once, (std::vector<std::string>{"speed", "move 1", "speed", "start stages", "start run",
                                            "capture begins", "start camera", "move 2", "arm",
                                            "expect profiles", "disarm", "bind", "triangulate",
                                            "stop camera", "restore camera", "capture ends"}));
  EXPECT_TRUE(stages_.whole_cloud);
  EXPECT_EQ(stages_.finished_pulses, 77U);
  EXPECT_TRUE(cell_.noted("keep alive"));
}

TEST_F(ScanSequence, SwitchesTheLasersOnOnlyOnceTheRobotMoves) {
  run();
  EXPECT_TRUE(trigger_.moving_when_armed);
}

TEST_F(ScanSequence, RefusesABadRequestBeforeAnythingMoves) {
  request_.passes[0].speed = 100;
  EXPECT_EQ(run().outcome, Outcome::kRefused);
  EXPECT_TRUE(cell_.log.empty());
}

TEST_F(ScanSequence, EndsSafelyWithTheReasonWhenADeviceIsLost) {
  const std::vector<std::pair<std::string, Outcome>> devices = {{"robot", Outcome::kRobotLost},
                                                                {"camera", Outcome::kCameraLost},
                                                                {"trigger", Outcome::kTriggerLost},
                                                                {"stages", Outcome::kStageFailed}};
  for (const auto& [device, outcome] : devices) {
    SCOPED_TRACE(device);
    cell_ = ScannedCell();
    cell_.trouble_of = device;
    observer_.last = 0;
    const scan_cell::SequenceEnd end = run();
    EXPECT_EQ(end.outcome, outcome);
    EXPECT_EQ(end.message, device + " is lost");
    expect_safe();
  }
}

TEST_F(ScanSequence, EndsSafelyWhereTheRobotIsNotSeenAtTwoLooksInARow) {
  robot_.unseen_from = 2;
  robot_.unseen_until = 4;
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kRobotLost);
  EXPECT_EQ(end.message, "robot: no pose");
  expect_safe();
}

TEST_F(ScanSequence, GoesOnWhereTheRobotIsNotSeenAtOneLookOnly) {
  robot_.unseen_from = 2;
  robot_.unseen_until = 3;
  EXPECT_EQ(run().outcome, Outcome::kFinished) << "this process may have been held up itself";
}

TEST_F(ScanSequence, StopsTheRobotAndKeepsTheDataWhenCancelled) {
  observer_.cancel = &cancel_;
  EXPECT_EQ(run().outcome, Outcome::kCancelled);
  expect_safe();
}

TEST_F(ScanSequence, SaysWhyAMotionFailed) {
  robot_.fails = true;
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kMotionFailed);
  EXPECT_EQ(end.message, "collision");
  expect_safe();
}

TEST_F(ScanSequence, TellsARobotThatRefusesFromOneThatIsLost) {
  for (const std::string call : {"speed", "move 1", "move 2"}) {
    SCOPED_TRACE(call);
    cell_ = ScannedCell();
    cell_.refused_at = call;
    observer_.last = 0;
    scan_cell::SequenceEnd end = run();
    EXPECT_EQ(end.outcome, Outcome::kMotionFailed);
    EXPECT_EQ(end.message, call + ": refused; ask for less");
    cell_ = ScannedCell();
    cell_.throws_at = call;
    observer_.last = 0;
    end = run();
    EXPECT_EQ(end.outcome, Outcome::kRobotLost);
    EXPECT_EQ(end.message, call + ": gone; look for it");
  }
}

TEST_F(ScanSequence, NeverSwitchesTheLasersOnWhereTheRobotDoesNotMove) {
  robot_.stuck = true;
  timing_.stall = 0.02;
  EXPECT_EQ(run().outcome, Outcome::kMotionFailed);
  EXPECT_FALSE(cell_.noted("arm"));
  EXPECT_TRUE(cell_.noted("stop robot"));
}

TEST_F(ScanSequence, NeverSwitchesTheLasersOnWhereTheScanMoveFailsAtOnce) {
  const std::vector<std::pair<Motion::State, Outcome>> ends = {
      {Motion::State::kFailed, Outcome::kMotionFailed},
      {Motion::State::kLost, Outcome::kRobotLost}};
  for (const auto& [state, outcome] : ends) {
    robot_.ends_at_once = state;
    cell_ = ScannedCell();
    observer_.last = 0;
    const scan_cell::SequenceEnd end = run();
    EXPECT_EQ(end.outcome, outcome);
    EXPECT_EQ(end.message, "no path");
    EXPECT_FALSE(cell_.noted("arm"));
    EXPECT_TRUE(cell_.noted("triangulate"));
  }
}

TEST_F(ScanSequence, DisarmsEvenWhereArmingFailed) {
  cell_.throws_at = "arm";
  EXPECT_EQ(run().outcome, Outcome::kTriggerLost);
  expect_safe();
}

TEST_F(ScanSequence, KeepsTheCloudWhereTheBinderFails) {
  cell_.throws_at = "bind";
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kStageFailed);
  EXPECT_NE(end.message.find("bind: gone"), std::string::npos) << end.message;
  EXPECT_TRUE(cell_.noted("triangulate"));
  EXPECT_FALSE(stages_.whole_cloud);
  EXPECT_TRUE(cell_.noted("stop camera"));
}

TEST_F(ScanSequence, ReportsATriangulationThatFails) {
  cell_.throws_at = "triangulate";
  EXPECT_EQ(run().outcome, Outcome::kStageFailed);
  EXPECT_TRUE(cell_.noted("stop camera"));
}

TEST_F(ScanSequence, SaysWhatFailedBesides) {
  robot_.fails = true;
  cell_.throws_at = "bind";
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kMotionFailed);
  EXPECT_EQ(end.message, "collision; in addition: bind: gone; look for it");
}

TEST_F(ScanSequence, IsNotFinishedWhereTheCameraWasLostAtTheVeryEnd) {
  stages_.missing_at_the_end = 4;
  EXPECT_EQ(run().outcome, Outcome::kFinished) << "single frames may get lost";
  stages_.missing_at_the_end = 5;
  observer_.last = 0;
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kCameraLost);
  EXPECT_EQ(end.message.find("camera: no frame of the last 5 of 77 pulses"), 0U) << end.message;
  EXPECT_FALSE(stages_.whole_cloud);
}

TEST_F(ScanSequence, IsNotFinishedWhereTheTriggerWasLostAtTheVeryEnd) {
  trigger_.answers = false;
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kTriggerLost);
  EXPECT_EQ(end.message, "trigger: no answer");
  EXPECT_FALSE(stages_.whole_cloud);
}
