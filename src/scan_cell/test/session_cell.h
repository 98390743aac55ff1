// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

#include "scan_cell_common/errors/errors.h"
#include "sequence/session_sequence.h"

using scan_cell::Motion;
using scan_cell::Outcome;

/// A cell whose devices record what they are told, for the sequence of a session.
namespace session_test {

/// A cell without hardware that records what it is told. Poses are distinguished by their x.
struct FakeCell {
  std::vector<std::string> log;
  int pose = 0;             // the latest target, from 1
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
  std::optional<scan_cell::MovesCheck> check(const std::vector<scan_cell::PlannedMove>&) override {
    return std::nullopt;
  }
  void start_move(const scan_cell::MoveTarget& to, double) override {
    target = to.flange;
    ++cell.pose;
    looks = 0;
    cell.note("move " + std::to_string(cell.pose));
  }
  Motion motion() const override {
    const auto end = ends.find(cell.pose);
    if (++looks < 3) return {Motion::State::kMoving, 0.1 * looks, ""};
    return end == ends.end() ? Motion{Motion::State::kReached, 1, ""} : end->second;
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
  std::map<int, Motion> ends;  // of the motion to a pose, if it does not arrive
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
  bool check(double r, const scan_cell::Lighting& lighting) override {
    if (r < least_rate)
      throw scan_cell_common::Refused("rate", "laser mask " + std::to_string(lighting.lasers),
                                      "pulse faster");
    return true;
  }
  void arm(double r, const scan_cell::Lighting& lighting) override {
    rates.push_back(r);
    cell.armed = true;
    cell.lasers = lighting.lasers;
    cell.note("arm " + std::to_string(lighting.lasers));
  }
  scan_cell::Disarmed disarm() noexcept override {
    cell.log.emplace_back("disarm");
    cell.armed = false;
    cell.lasers = 0;
    return {1, 5, answers ? "" : "trigger: no answer"};
  }
  void keep_alive() override { cell.note("keep alive"); }
  FakeCell& cell;
  std::vector<double> rates;
  double least_rate = 0;  // [Hz] that it accepts
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

  /// Expects the lasers off, the camera as before, and no motion begun after the end.
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

}  // namespace session_test
