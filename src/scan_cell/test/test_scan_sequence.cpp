// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "scan_cell_common/errors/errors.h"
#include "sequence/scan_sequence.h"

using scan_cell::Motion;
using scan_cell::Outcome;

namespace {

/// A cell without hardware: it writes down what it is told, and each look at the motion takes it
/// on.
struct FakeCell {
  std::vector<std::string> log;
  int looks = 0;  // at the motion under way
  int moves = 0;  // motions started
  bool armed = false;
  std::string trouble_of;  // device that gets into trouble half way through the scan
  std::string throws_at;   // call that finds its device gone
  std::string refused_at;  // call that the device refuses

  void note(const std::string& call) {
    log.push_back(call);
    if (call == throws_at) throw scan_cell_common::ConnectionError(call, "gone", "look for it");
    if (call == refused_at) throw scan_cell_common::Refused(call, "refused", "ask for less");
  }
  bool noted(const std::string& call) const {
    return std::find(log.begin(), log.end(), call) != log.end();
  }
  std::size_t place(const std::string& call) const {
    return static_cast<std::size_t>(std::find(log.begin(), log.end(), call) - log.begin());
  }
  bool half_way() const { return moves == 2 && looks >= 5; }
  std::string trouble(const std::string& device) const {
    return device == trouble_of && half_way() ? device + " is lost" : "";
  }
};

struct FakeRobot : scan_cell::Robot {
  explicit FakeRobot(FakeCell& c) : cell(c) {}
  std::string trouble() const override { return cell.trouble("robot"); }
  void set_linear_motion(double) override { cell.note("speed"); }
  void start_move(const Eigen::Isometry3d&, double) override {
    cell.looks = 0;
    ++cell.moves;
    cell.note("move " + std::to_string(cell.moves));
  }
  Motion motion() const override {
    ++cell.looks;
    if (stuck && cell.moves == 2) return {Motion::State::kMoving, 0, ""};
    if (ends_at_once && cell.moves == 2) return {*ends_at_once, 0, "no path"};
    if (cell.half_way() && fails) return {Motion::State::kFailed, 0.5, "collision"};
    if (cell.looks >= 10) return {Motion::State::kReached, 1, ""};
    return {Motion::State::kMoving, std::max(0, cell.looks - 2) / 10.0, ""};
  }
  std::string unseen() const override {
    const bool is = unseen_from <= looks_for_it && looks_for_it < unseen_until;
    ++looks_for_it;
    return is ? "robot: no pose" : "";
  }
  std::string hindrance() const override { return ""; }
  Eigen::Isometry3d static_pose() override { return Eigen::Isometry3d::Identity(); }
  void stop() noexcept override { cell.log.emplace_back("stop robot"); }
  FakeCell& cell;
  bool fails = false;
  bool stuck = false;
  int unseen_from = 0, unseen_until = 0;  // in looks for it
  mutable int looks_for_it = 0;
  std::optional<Motion::State> ends_at_once;
};

struct FakeCamera : scan_cell::Camera {
  explicit FakeCamera(FakeCell& c) : cell(c) {}
  std::string trouble() const override { return cell.trouble("camera"); }
  void start() override { cell.note("start camera"); }
  void expect_profiles(double) override { cell.note("expect profiles"); }
  void stop() noexcept override { cell.log.emplace_back("stop camera"); }
  FakeCell& cell;
};

struct FakeTrigger : scan_cell::Trigger {
  FakeTrigger(FakeCell& c, const FakeRobot& r) : cell(c), robot(r) {}
  std::string trouble() const override { return cell.trouble("trigger"); }
  void arm(double, const scan_cell::Lighting&) override {
    moving_when_armed = robot.motion().progress > 0;
    cell.note("arm");
    cell.armed = true;
  }
  scan_cell::Disarmed disarm() noexcept override {
    cell.log.emplace_back("disarm");
    cell.armed = false;
    return {77, answers ? "" : "trigger: no answer"};
  }
  void keep_alive() override { cell.note("keep alive"); }
  FakeCell& cell;
  const FakeRobot& robot;
  bool moving_when_armed = false;
  bool answers = true;
};

struct FakeStages : scan_cell::Stages {
  explicit FakeStages(FakeCell& c) : cell(c) {}
  std::string trouble() const override { return cell.trouble("stages"); }
  void start(const std::string&) override { cell.note("start stages"); }
  std::uint64_t bind(std::uint64_t pulses, double) override {
    finished_pulses = pulses;
    cell.note("bind");
    return missing_at_the_end;
  }
  void triangulate(bool whole, double) override {
    whole_cloud = whole;
    cell.note("triangulate");
  }
  FakeCell& cell;
  std::uint64_t missing_at_the_end = 0;
  bool whole_cloud = false;
  std::uint64_t finished_pulses = 0;
};

struct FakeObserver : scan_cell::ScanObserver {
  explicit FakeObserver(FakeCell& c) : cell(c) {}
  void on_progress(int step, const std::string&, double progress) override {
    if (steps.empty() || steps.back() != step) steps.push_back(step);
    EXPECT_GE(progress, last);
    last = progress;
    if (cancel != nullptr && cell.half_way()) *cancel = true;
  }
  void on_capture_begins() override { cell.note("capture begins"); }
  void on_capture_ends() override { cell.note("capture ends"); }
  FakeCell& cell;
  std::vector<int> steps;
  double last = 0;
  std::atomic<bool>* cancel = nullptr;
};

class ScanSequence : public testing::Test {
 protected:
  ScanSequence() {
    request_.scan_id = "test";
    request_.start.translation() << 0.6, 0, 0.6;
    request_.end.translation() << 0.9, 0, 0.6;
    request_.speed = 0.1;
    request_.rate = 100;
    request_.lasers = 1;
    timing_.poll = 1e-4;
    timing_.keep_alive = 0;
  }

  scan_cell::SequenceEnd run() {
    scan_cell::ScanSequence sequence(robot_, camera_, trigger_, stages_, observer_, {}, timing_);
    return sequence.run(request_, [this] { return cancel_ ? "cancelled" : ""; });
  }

  void expect_safe() const {
    EXPECT_FALSE(cell_.armed);
    EXPECT_TRUE(cell_.noted("disarm"));
    EXPECT_TRUE(cell_.noted("stop robot"));
    EXPECT_LT(cell_.place("disarm"), cell_.place("stop robot"));
    EXPECT_TRUE(cell_.noted("stop camera"));
    EXPECT_EQ(stages_.finished_pulses, 77U) << "what was captured must be kept";
    EXPECT_TRUE(cell_.noted("triangulate"));
    EXPECT_FALSE(stages_.whole_cloud);
    EXPECT_EQ(cell_.log.back(), "capture ends");
  }

  FakeCell cell_;
  FakeRobot robot_{cell_};
  FakeCamera camera_{cell_};
  FakeTrigger trigger_{cell_, robot_};
  FakeStages stages_{cell_};
  FakeObserver observer_{cell_};
  scan_cell::ScanRequest request_;
  scan_cell::ScanSequence::Timing timing_;
  std::atomic<bool> cancel_{false};
};

}  // namespace

TEST_F(ScanSequence, DoesTheEightStepsInTheirOrder) {
  const scan_cell::SequenceEnd end = run();
  EXPECT_EQ(end.outcome, Outcome::kFinished) << end.message;
  EXPECT_EQ(observer_.steps, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
  std::vector<std::string> once = cell_.log;
  once.erase(std::remove(once.begin(), once.end(), "keep alive"), once.end());
  EXPECT_EQ(once,
            (std::vector<std::string>{"speed", "move 1", "speed", "start stages", "capture begins",
                                      "start camera", "move 2", "arm", "expect profiles", "disarm",
                                      "bind", "triangulate", "stop camera", "capture ends"}));
  EXPECT_TRUE(stages_.whole_cloud);
  EXPECT_EQ(stages_.finished_pulses, 77U);
  EXPECT_TRUE(cell_.noted("keep alive"));
}

TEST_F(ScanSequence, SwitchesTheLasersOnOnlyOnceTheRobotMoves) {
  run();
  EXPECT_TRUE(trigger_.moving_when_armed);
}

TEST_F(ScanSequence, RefusesABadRequestBeforeAnythingMoves) {
  request_.speed = 100;
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
    cell_ = FakeCell();
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
    cell_ = FakeCell();
    cell_.refused_at = call;
    observer_.last = 0;
    scan_cell::SequenceEnd end = run();
    EXPECT_EQ(end.outcome, Outcome::kMotionFailed);
    EXPECT_EQ(end.message, call + ": refused; ask for less");
    cell_ = FakeCell();
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
    cell_ = FakeCell();
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
  EXPECT_EQ(end.message, "collision; besides: bind: gone; look for it");
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
