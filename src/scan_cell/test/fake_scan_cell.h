// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <system_error>
#include <vector>

#include "scan_cell_common/errors/errors.h"
#include "sequence/scan_sequence.h"

namespace scan_sequence_test {

using scan_cell::Motion;
using scan_cell::Outcome;

/// A cell without hardware: it records what it is told, and each check of the motion advances the
/// motion.
struct FakeCell {
  std::vector<std::string> log;
  int looks = 0;  // checks of the present motion
  int moves = 0;  // motions started
  bool armed = false;
  std::string trouble_of;                   // device that reports trouble half-way through the scan
  std::string throws_at;                    // call whose device is gone
  std::string refused_at;                   // call that the device refuses
  std::optional<std::size_t> unbound_pass;  // pass that the stages refuse

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
  std::optional<scan_cell::MovesCheck> check(
      const std::vector<scan_cell::PlannedMove>& moves) override {
    checked = moves;
    if (cell.throws_at == "check") cell.note("check");
    if (!impossible)
      return checks ? std::optional(scan_cell::MovesCheck{moves.size(), "", {}}) : std::nullopt;
    return scan_cell::MovesCheck{*impossible, "line: passes a singular posture",
                                 Eigen::Vector3d(1, 2, 3)};
  }
  void start_move(const scan_cell::MoveTarget& target, double) override {
    targets.push_back(target);
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
  std::vector<scan_cell::MoveTarget> targets;
  std::vector<scan_cell::PlannedMove> checked;
  bool checks = true;                     // its driver has the service
  std::optional<std::size_t> impossible;  // index among the motions checked
  bool fails = false;
  bool stuck = false;
  int unseen_from = 0, unseen_until = 0;  // in checks for it
  mutable int looks_for_it = 0;
  std::optional<Motion::State> ends_at_once;
};

struct FakeCamera : scan_cell::Camera {
  explicit FakeCamera(FakeCell& c) : cell(c) {}
  std::string trouble() const override { return cell.trouble("camera"); }
  void start(const scan_cell::PassCamera& wanted) override {
    EXPECT_FALSE(cell.armed) << "no frame may be exposed half way between two settings";
    settings.push_back(wanted);
    cell.note("start camera");
  }
  double exposure() const override { return settings.back().exposure.value_or(0.001); }
  void expect_profiles(double rate) override {
    if (rate > 0) cell.note("expect profiles");
  }
  void stop() noexcept override { cell.log.emplace_back("stop camera"); }
  std::string restore() noexcept override {
    cell.log.emplace_back("restore camera");
    return restores ? "" : "camera: not as before";
  }
  FakeCell& cell;
  std::vector<scan_cell::PassCamera> settings;  // of each start
  bool restores = true;
};

struct FakeTrigger : scan_cell::Trigger {
  FakeTrigger(FakeCell& c, const FakeRobot& r) : cell(c), robot(r) {}
  std::string trouble() const override { return cell.trouble("trigger"); }
  bool check(double, const scan_cell::Lighting& lighting) override {
    if (lighting.alternate && lighting.exposure > most_to_alternate)
      throw scan_cell_common::Refused("rate", "100 Hz to alternate", "expose for less");
    return checks;
  }
  void arm(double, const scan_cell::Lighting& lighting) override {
    moving_when_armed = robot.motion().progress > 0;
    EXPECT_FALSE(cell.armed) << "between passes the lasers are off";
    armings.push_back(lighting);
    cell.note("arm");
    cell.armed = true;
  }
  scan_cell::Disarmed disarm() noexcept override {
    cell.log.emplace_back("disarm");
    cell.armed = false;
    return {static_cast<std::uint32_t>(armings.size()), armings.size() == silent_arming ? 0U : 77U,
            answers ? "" : "trigger: no answer"};
  }
  void keep_alive() override { cell.note("keep alive"); }
  FakeCell& cell;
  const FakeRobot& robot;
  std::vector<scan_cell::Lighting> armings;
  bool checks = true;            // its node has the service
  double most_to_alternate = 1;  // [s] exposure
  bool moving_when_armed = false;
  bool answers = true;
  std::size_t silent_arming = 0;  // arming that sends no pulse, from 1; 0: each sends some
};

struct FakeStages : scan_cell::Stages {
  explicit FakeStages(FakeCell& c) : cell(c) {}
  std::string trouble() const override { return cell.trouble("stages"); }
  void start(const std::string&) override { cell.note("start stages"); }
  void check_run(const scan_cell::ScanRun& run) override {
    if (run.pass == cell.unbound_pass)
      throw scan_cell_common::Refused("pass", "cannot be bound", "use another method");
  }
  void start_run(const scan_cell::ScanRun& run) override {
    passes.push_back(run.pass);
    cell.note("start run");
  }
  std::vector<std::uint64_t> bind(const std::vector<scan_cell::ArmingPulses>& armings,
                                  double) override {
    finished_pulses = 0;
    for (const scan_cell::ArmingPulses& arming : armings)
      finished_pulses += arming.pulses;
    cell.note("bind");
    if (breaks) throw std::system_error(std::make_error_code(std::errc::no_space_on_device));
    return std::vector<std::uint64_t>(armings.size(), missing_at_the_end);
  }
  void triangulate(bool whole, double) override {
    whole_cloud = whole;
    cell.note("triangulate");
  }
  std::string disagreement() const override { return apart; }
  std::string apart;
  FakeCell& cell;
  std::vector<std::size_t> passes;  // of the runs
  std::uint64_t missing_at_the_end = 0;
  bool breaks = false;  // with an error that is not one of the suite's
  bool whole_cloud = false;
  std::uint64_t finished_pulses = 0;
};

struct FakeObserver : scan_cell::ScanObserver {
  explicit FakeObserver(FakeCell& c) : cell(c) {}
  void on_progress(const scan_cell::ScanProgress& progress) override {
    if (steps.empty() || steps.back() != progress.step) steps.push_back(progress.step);
    EXPECT_GE(progress.whole, last);
    last = progress.whole;
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
    request_.passes = {line(0.6, 0.9)};
    timing_.poll = 1e-4;
    timing_.keep_alive = 0;
  }

  static Eigen::Isometry3d at(double x, double y = 0) {
    return Eigen::Isometry3d(Eigen::Translation3d(x, y, 0.6));
  }
  static scan_cell::ScanPass line(double from, double to) {
    scan_cell::ScanPass pass;
    pass.poses = {at(from), at(to)};
    pass.speed = 0.1;
    pass.rate = 100;
    return pass;
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

}  // namespace scan_sequence_test
