// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "session_cell.h"

using session_test::FakeCell;
using session_test::SessionSequence;

TEST_F(SessionSequence, NeverMovesAgainAfterTheRobotWasStopped) {
  robot_.ends[2] = {Motion::State::kStopped, 0.5, "stopped at the pendant"};
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kMotionFailed);
  EXPECT_EQ(result.end.message, "stopped at the pendant");
  EXPECT_EQ(cell_.count("move 3"), 0);
  EXPECT_EQ(result.views, 1);
  expect_safe();
}

TEST_F(SessionSequence, NeverGoesOnWhereARefusalIsAnEmergencyStop) {
  robot_.ends[2] = {Motion::State::kFailed, 0, "refused"};
  robot_.hindered = "emergency stop";
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kMotionFailed);
  EXPECT_EQ(result.end.message, "refused (emergency stop)");
  EXPECT_EQ(cell_.count("move 3"), 0) << "it would start by itself when the stop is released";
  expect_safe();
}

TEST_F(SessionSequence, EndsWhereTheRobotMakesNoWay) {
  robot_.ends[1] = {Motion::State::kMoving, 0.2, ""};
  timing_.stall = 0.02;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kMotionFailed);
  EXPECT_NE(result.end.message.find("has not moved"), std::string::npos);
  EXPECT_EQ(cell_.count("stop robot"), 1);
  expect_safe();
}

TEST_F(SessionSequence, EndsSafelyWhereTheRobotIsLost) {
  robot_.trouble_from = 3;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kRobotLost);
  EXPECT_EQ(result.end.message, "robot is lost");
  EXPECT_EQ(result.views, 2);
  EXPECT_EQ(cell_.count("stop robot"), 1);
  expect_safe();
}

TEST_F(SessionSequence, SwitchesTheLaserOffWhereTheTriggerIsLost) {
  trigger_.lost = true;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kTriggerLost);
  EXPECT_EQ(cell_.count("arm 1"), 0);
  expect_safe();
}

TEST_F(SessionSequence, DisarmsEvenWhereArmingFailed) {
  cell_.throws_at = "arm 2";
  EXPECT_EQ(run().end.outcome, Outcome::kTriggerLost);
  EXPECT_GT(cell_.last("disarm"), cell_.last("arm 2"));
  expect_safe();
}

TEST_F(SessionSequence, EndsWhereTheTriggerDoesNotAnswerWhenDisarmed) {
  trigger_.answers = false;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kTriggerLost);
  EXPECT_EQ(result.end.message, "trigger: no answer");
  EXPECT_EQ(cell_.count("arm 1"), 0) << "another laser on top of one that may be on";
}

TEST_F(SessionSequence, KeepsTheTriggerAliveForAsLongAsALaserIsOn) {
  timing_.image_patience = 0.02;
  camera_.blind_from = 1;
  timing_.max_blind_poses = 1;
  EXPECT_EQ(run().end.outcome, Outcome::kCameraLost);
  EXPECT_GT(cell_.count("keep alive"), 5);
}

TEST_F(SessionSequence, SwitchesTheLaserOffAndNeverMovesAgainWhenCancelled) {
  for (const std::string& at :
       std::vector<std::string>{"move 2", "pose", "arm 0", "arm 1", "arm 2", "record"}) {
    SCOPED_TRACE(at);
    cell_ = FakeCell();
    cell_.on_call = [&](const std::string& call) {
      if (call == at) cancel_ = true;
    };
    cancel_ = false;
    observer_.last = 0;
    const scan_cell::SessionEnd result = run();
    EXPECT_EQ(result.end.outcome, Outcome::kCancelled);
    EXPECT_EQ(cell_.count("move " + std::to_string(at == "move 2" ? 3 : 2)), 0)
        << "it moved after the cancel";
    EXPECT_EQ(cell_.count("stop robot"), at == "move 2" ? 1 : 0);
    expect_safe();
  }
}

TEST_F(SessionSequence, EndsWhereTheSessionCannotBeWritten) {
  cell_.throws_at = "record";
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kStageFailed);
  EXPECT_EQ(result.views, 0);
  expect_safe();
}

TEST_F(SessionSequence, RestoresTheCameraWherePreparingItFailedHalfWay) {
  cell_.throws_at = "whole sensor";
  EXPECT_EQ(run().end.outcome, Outcome::kCameraLost);
  EXPECT_EQ(cell_.count("move 1"), 0);
  expect_safe();
}

TEST_F(SessionSequence, SaysWhereTheCameraCouldNotBeRestored) {
  camera_.restore_trouble = "camera: its region was not restored";
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kCameraLost);
  EXPECT_EQ(result.end.message, "camera: its region was not restored");
  EXPECT_EQ(result.views, 4);
}

TEST_F(SessionSequence, RefusesARateThatTheTriggerDoesNotTakeBeforeAnythingMoves) {
  trigger_.least_rate = 5;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kRefused);
  EXPECT_EQ(result.end.message, "rate: laser mask 0; pulse faster") << "2.5 Hz, with 0.2 s";
  EXPECT_TRUE(cell_.log.empty());
}

TEST_F(SessionSequence, RefusesWhatMakesNoSenseBeforeAnythingMoves) {
  const std::vector<std::function<void(scan_cell::SessionRequest&)>> mistakes = {
      [](auto& request) { request.poses.clear(); }, [](auto& request) { request.lasers = 4; },
      [](auto& request) { request.line_exposure = 0; },
      [](auto& request) { request.board_exposure = 20; },
      [](auto& request) { request.board_exposure = std::nan(""); }};
  const scan_cell::SessionRequest good = request_;
  for (const auto& mistake : mistakes) {
    request_ = good;
    mistake(request_);
    EXPECT_EQ(run().end.outcome, Outcome::kRefused);
    EXPECT_TRUE(cell_.log.empty());
  }
}
