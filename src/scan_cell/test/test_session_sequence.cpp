// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

#include "scan_cell_common/errors.h"
#include "sequence/session_sequence.h"

using scan_cell::Motion;
using scan_cell::Outcome;

namespace {

/// A cell without hardware that writes down what it is told. Poses are told apart by their x.
struct FakeCell {
  std::vector<std::string> log;
  int pose = 0;             // the one driven to last, from 1
  std::uint8_t lasers = 0;  // on
  bool armed = false;
  std::string throws_at;  // call that throws
  std::function<void(const std::string&)> on_call = [](const std::string&) {};

  void note(const std::string& call) {
    log.push_back(call);
    on_call(call);
    if (call == throws_at) throw scan_cell_common::ConnectionError(call, "gone", "look for it");
  }
  long count(const std::string& call) const { return std::count(log.begin(), log.end(), call); }
  std::size_t last(const std::string& call) const {
    return static_cast<std::size_t>(log.rend() - std::find(log.rbegin(), log.rend(), call));
  }
};

struct FakeRobot : scan_cell::Robot {
  explicit FakeRobot(FakeCell& c) : cell(c) {}
  std::string trouble() const override { return trouble_from == cell.pose ? "robot is lost" : ""; }
  void set_linear_motion(double) override { cell.note("speed"); }
  void start_move(const Eigen::Isometry3d& flange, double) override {
    target = flange;
    ++cell.pose;
    looks = 0;
    cell.note("move " + std::to_string(cell.pose));
  }
  Motion motion() const override {
    const auto end = ends.find(cell.pose);
    if (++looks < 3) return {Motion::State::Moving, 0.1 * looks, ""};
    return end == ends.end() ? Motion{Motion::State::Reached, 1, ""} : end->second;
  }
  std::string unseen() const override { return ""; }
  std::string hindrance() const override { return hindered; }
  Eigen::Isometry3d static_pose() override {
    cell.note("pose");
    Eigen::Isometry3d measured = target;
    measured.translation().z() += 1e-5;
    if (restless_at == cell.pose) measured.translation().x() += 1e-3 * ++steps;
    if (slips_at == cell.pose && cell.count("image") > 0) measured.translation().x() += 1e-3;
    return measured;
  }
  void stop() noexcept override { cell.log.emplace_back("stop robot"); }
  FakeCell& cell;
  Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
  std::map<int, Motion> ends;  // of the motion to a pose, where it does not get there
  std::string hindered;
  int trouble_from = -1;
  int restless_at = -1;
  int slips_at = -1;
  int steps = 0;
  mutable int looks = 0;
};

struct FakeCamera : scan_cell::SnapshotCamera {
  explicit FakeCamera(FakeCell& c) : cell(c) {}
  void prepare() override { cell.note("whole sensor"); }
  void start(double exposure) override {
    EXPECT_FALSE(cell.armed) << "a pulse could be of the laser before";
    exposures.push_back(exposure);
    cell.note("start camera");
  }
  std::optional<scan_cell::Snapshot> snapshot() override {
    if (!cell.armed || (blind_from >= 0 && cell.pose >= blind_from && cell.pose <= blind_to)) {
      return std::nullopt;
    }
    cell.note("image");
    scan_cell::Snapshot snapshot;
    snapshot.image = cv::Mat(1, 1, CV_8UC1, cv::Scalar(cell.lasers));
    return snapshot;
  }
  void stop() noexcept override { cell.log.emplace_back("stop camera"); }
  std::string restore() noexcept override {
    cell.log.emplace_back("restore");
    return restore_trouble;
  }
  FakeCell& cell;
  std::vector<double> exposures;
  int blind_from = -1;
  int blind_to = 1000;
  std::string restore_trouble;
};

struct FakeTrigger : scan_cell::Trigger {
  explicit FakeTrigger(FakeCell& c) : cell(c) {}
  std::string trouble() const override { return lost && cell.armed ? "trigger is lost" : ""; }
  void arm(double r, std::uint8_t lasers) override {
    rates.push_back(r);
    cell.armed = true;
    cell.lasers = lasers;
    cell.note("arm " + std::to_string(lasers));
  }
  scan_cell::Disarmed disarm() noexcept override {
    cell.log.emplace_back("disarm");
    cell.armed = false;
    cell.lasers = 0;
    return {5, answers ? "" : "trigger: no answer"};
  }
  void keep_alive() override { cell.note("keep alive"); }
  FakeCell& cell;
  std::vector<double> rates;
  bool lost = false;
  bool answers = true;
};

struct FakeObserver : scan_cell::SessionObserver {
  explicit FakeObserver(FakeCell& c) : cell(c) {}
  void on_progress(int pose, const std::string&, double progress) override {
    EXPECT_GE(progress, last);
    EXPECT_LE(progress, 1);
    EXPECT_EQ(pose, static_cast<int>(std::min(progress * poses + 1e-9, poses - 1.0)) + 1);
    last = progress;
  }
  void on_view(const scan_cell::TakenView& view) override {
    EXPECT_FALSE(cell.armed) << "a slow disk must not keep a laser on";
    cell.note("record");
    views.push_back(view);
  }
  FakeCell& cell;
  double poses = 4;
  double last = 0;
  std::vector<scan_cell::TakenView> views;
};

class SessionSequence : public testing::Test {
 protected:
  SessionSequence() {
    for (int i = 1; i <= 4; ++i) {
      scan_cell::TaughtPose pose;
      pose.name = "line " + std::to_string(i + 1);
      pose.flange.translation().x() = i;
      request_.poses.push_back(pose);
    }
    request_.lasers = 3;
    request_.board_exposure = 0.2;
    request_.line_exposure = 0.001;
    timing_.poll = 1e-4;
    timing_.keep_alive = 0;
    timing_.settle = timing_.still_interval = timing_.aftermath = 1e-3;
    timing_.still_patience = timing_.image_patience = 0.02;
  }

  scan_cell::SessionEnd run() {
    scan_cell::SessionSequence sequence(robot_, camera_, trigger_, observer_, {}, timing_);
    return sequence.run(request_, [this] { return cancel_ ? "cancelled" : ""; });
  }

  /// Lasers off, camera as it was, and no motion begun after the end.
  void expect_safe() const {
    EXPECT_FALSE(cell_.armed);
    EXPECT_EQ(cell_.count("arm 0") + cell_.count("arm 1") + cell_.count("arm 2"),
              cell_.count("disarm"));
    EXPECT_EQ(cell_.log.back(), "restore");
    EXPECT_EQ(cell_.log[cell_.log.size() - 2], "stop camera");
  }

  FakeCell cell_;
  FakeRobot robot_{cell_};
  FakeCamera camera_{cell_};
  FakeTrigger trigger_{cell_};
  FakeObserver observer_{cell_};
  scan_cell::SessionRequest request_;
  scan_cell::SessionSequence::Timing timing_;
  std::atomic<bool> cancel_{false};
};

}  // namespace

TEST_F(SessionSequence, TakesTheBoardInTheDarkAndEachLaserAloneAtEachPose) {
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::Finished) << result.end.message;
  EXPECT_EQ(result.views, 4);
  EXPECT_TRUE(result.skipped.empty());
  ASSERT_EQ(observer_.views.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    const scan_cell::TakenView& view = observer_.views[i];
    EXPECT_EQ(view.base_to_flange.translation(), Eigen::Vector3d(i + 1, 0, 1e-5))
        << "the measured pose, not the taught one";
    EXPECT_EQ(view.board.image.at<std::uint8_t>(0), 0);
    ASSERT_EQ(view.lines.size(), 2U);
    EXPECT_EQ(view.lines[0].image.at<std::uint8_t>(0), 1);
    EXPECT_EQ(view.lines[1].image.at<std::uint8_t>(0), 2);
  }
  EXPECT_EQ(camera_.exposures.size(), 12U);
  EXPECT_EQ(camera_.exposures[0], 0.2);
  EXPECT_EQ(camera_.exposures[1], 0.001);
  EXPECT_LT(trigger_.rates[0], 1 / 0.2) << "pulses must not come before the exposure is over";
  expect_safe();
}

TEST_F(SessionSequence, TakesOnlyTheLasersAskedFor) {
  request_.lasers = 2;
  EXPECT_EQ(run().views, 4);
  EXPECT_EQ(cell_.count("arm 1"), 0);
  EXPECT_EQ(observer_.views[0].lines.size(), 1U);
}

TEST_F(SessionSequence, TakesTheBoardAloneWithoutALaser) {
  request_.lasers = 0;
  EXPECT_EQ(run().views, 4);
  EXPECT_EQ(cell_.count("arm 1") + cell_.count("arm 2"), 0);
  EXPECT_TRUE(observer_.views[0].lines.empty());
  EXPECT_EQ(camera_.exposures.size(), 4U);
  expect_safe();
}

TEST_F(SessionSequence, SkipsAndNamesAPoseThatTheRobotRefuses) {
  robot_.ends[2] = {Motion::State::Failed, 0, "out of reach"};
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::Finished);
  EXPECT_EQ(result.views, 3);
  ASSERT_EQ(result.skipped.size(), 1U);
  EXPECT_EQ(result.skipped[0].name, "line 3");
  EXPECT_EQ(result.skipped[0].reason, "out of reach");
  expect_safe();
}

TEST_F(SessionSequence, SkipsAPoseWhereTheRobotDoesNotComeToRest) {
  robot_.restless_at = 1;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.views, 3);
  ASSERT_EQ(result.skipped.size(), 1U);
  EXPECT_EQ(result.skipped[0].name, "line 2");
  EXPECT_NE(result.skipped[0].reason.find("rest"), std::string::npos);
}

TEST_F(SessionSequence, SkipsAPoseWhereTheRobotMovedWhileImagesWereTaken) {
  robot_.slips_at = 1;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.views, 3);
  ASSERT_EQ(result.skipped.size(), 1U);
  EXPECT_NE(result.skipped[0].reason.find("moved while"), std::string::npos);
}

TEST_F(SessionSequence, SkipsAPoseWithoutAnImageAndGoesOn) {
  camera_.blind_from = camera_.blind_to = 2;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::Finished);
  EXPECT_EQ(result.views, 3);
  ASSERT_EQ(result.skipped.size(), 1U);
  EXPECT_NE(result.skipped[0].reason.find("no image of the board"), std::string::npos);
  expect_safe();
}

TEST_F(SessionSequence, EndsAsCameraLostWhereSeveralPosesInARowGiveNoImage) {
  camera_.blind_from = 2;
  timing_.most_blind_poses = 2;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::CameraLost);
  EXPECT_EQ(result.views, 1) << "what was recorded is kept";
  EXPECT_EQ(result.skipped.size(), 2U);
  EXPECT_EQ(cell_.count("move 4"), 0);
  expect_safe();
}

TEST_F(SessionSequence, NeverMovesAgainAfterTheRobotWasStopped) {
  robot_.ends[2] = {Motion::State::Stopped, 0.5, "stopped at the pendant"};
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::MotionFailed);
  EXPECT_EQ(result.end.message, "stopped at the pendant");
  EXPECT_EQ(cell_.count("move 3"), 0);
  EXPECT_EQ(result.views, 1);
  expect_safe();
}

TEST_F(SessionSequence, NeverGoesOnWhereARefusalIsAnEmergencyStop) {
  robot_.ends[2] = {Motion::State::Failed, 0, "refused"};
  robot_.hindered = "emergency stop";
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::MotionFailed);
  EXPECT_EQ(result.end.message, "refused (emergency stop)");
  EXPECT_EQ(cell_.count("move 3"), 0) << "it would start by itself when the stop is released";
  expect_safe();
}

TEST_F(SessionSequence, EndsWhereTheRobotMakesNoWay) {
  robot_.ends[1] = {Motion::State::Moving, 0.2, ""};
  timing_.stall = 0.02;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::MotionFailed);
  EXPECT_NE(result.end.message.find("made no way"), std::string::npos);
  EXPECT_EQ(cell_.count("stop robot"), 1);
  expect_safe();
}

TEST_F(SessionSequence, EndsSafelyWhereTheRobotIsLost) {
  robot_.trouble_from = 3;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::RobotLost);
  EXPECT_EQ(result.end.message, "robot is lost");
  EXPECT_EQ(result.views, 2);
  EXPECT_EQ(cell_.count("stop robot"), 1);
  expect_safe();
}

TEST_F(SessionSequence, SwitchesTheLaserOffWhereTheTriggerIsLost) {
  trigger_.lost = true;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::TriggerLost);
  EXPECT_EQ(cell_.count("arm 1"), 0);
  expect_safe();
}

TEST_F(SessionSequence, DisarmsEvenWhereArmingFailed) {
  cell_.throws_at = "arm 2";
  EXPECT_EQ(run().end.outcome, Outcome::TriggerLost);
  EXPECT_GT(cell_.last("disarm"), cell_.last("arm 2"));
  expect_safe();
}

TEST_F(SessionSequence, EndsWhereTheTriggerDoesNotAnswerWhenDisarmed) {
  trigger_.answers = false;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::TriggerLost);
  EXPECT_EQ(result.end.message, "trigger: no answer");
  EXPECT_EQ(cell_.count("arm 1"), 0) << "another laser on top of one that may be on";
}

TEST_F(SessionSequence, KeepsTheTriggerAliveForAsLongAsALaserIsOn) {
  timing_.image_patience = 0.02;
  camera_.blind_from = 1;
  timing_.most_blind_poses = 1;
  EXPECT_EQ(run().end.outcome, Outcome::CameraLost);
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
    EXPECT_EQ(result.end.outcome, Outcome::Cancelled);
    EXPECT_EQ(cell_.count("move " + std::to_string(at == "move 2" ? 3 : 2)), 0)
        << "it moved after the cancel";
    EXPECT_EQ(cell_.count("stop robot"), at == "move 2" ? 1 : 0);
    expect_safe();
  }
}

TEST_F(SessionSequence, EndsWhereTheSessionCannotBeWritten) {
  cell_.throws_at = "record";
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::StageFailed);
  EXPECT_EQ(result.views, 0);
  expect_safe();
}

TEST_F(SessionSequence, RestoresTheCameraWherePreparingItFailedHalfWay) {
  cell_.throws_at = "whole sensor";
  EXPECT_EQ(run().end.outcome, Outcome::CameraLost);
  EXPECT_EQ(cell_.count("move 1"), 0);
  expect_safe();
}

TEST_F(SessionSequence, SaysWhereTheCameraCouldNotBeRestored) {
  camera_.restore_trouble = "camera: its region was not restored";
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::CameraLost);
  EXPECT_EQ(result.end.message, "camera: its region was not restored");
  EXPECT_EQ(result.views, 4);
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
    EXPECT_EQ(run().end.outcome, Outcome::Refused);
    EXPECT_TRUE(cell_.log.empty());
  }
}
