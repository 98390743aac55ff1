// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Whole paths of the tool on the emulated arm, compared with lines, zones and speeds in closed
/// form.
#include "controller/tool_path_test.h"

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using scan_cell_sim::ControllerErrorCode;
using scan_cell_sim::MotionStatus;

namespace {

constexpr double kAcceleration = 1.0;  // [m/s^2] at the start; c4g_protocol.md

class FollowedPaths : public ToolPaths {
 protected:
  /// Right angles, a reversal, a bend and a straight passage, some with a turn.
  void SetUp() override {
    add(60, 0, 0, 50, 1, 1);
    add(0, 80, 0, 80, 1, 3, 0.2);
    add(0, 0, 40, 80, 0, 2);
    add(-50, -30, 0, 100, 3, 6, -0.3);
    add(-50, -30, 0, 100, 2, 7);
    add(40, 24, 0, 30, 1, 0);
    add(10, -40, -20, 60, 5, 8, 0.1);
  }
};

}  // namespace

TEST_F(FollowedPaths, StayOnTheirLinesAndWithinTheirZones) {
  begin();
  const auto samples = all();
  ASSERT_EQ(samples.back().state.status, MotionStatus::kArrived);
  expect_on_the_path(samples);
  EXPECT_LT((samples.back().tip - waypoints_.back().tip.translation()).norm(), 1e-8);
  EXPECT_LT(AngleAxisd(samples.back().turn.transpose() * waypoints_.back().tip.linear()).angle(),
            1e-7);
}

TEST_F(FollowedPaths, CutTheirCornersWhereTheyMay) {
  begin();
  double farthest = 0;
  for (const Sample& sample : all())
    farthest = std::max(farthest, off_the_lines(sample.tip));
  EXPECT_GT(farthest, 0.2e-3) << "a rounding that begins 1 mm before a right angle";
}

TEST_F(FollowedPaths, HoldTheSpeedOfEachLineOutsideOfCorners) {
  begin();
  const auto samples = all();
  std::size_t looked_at = 0;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const auto line = static_cast<std::size_t>(samples[i].state.waypoint) + 1;
    if (line >= waypoints_.size() || samples[i + 1].state.waypoint + 1 != line) continue;
    const double speed = waypoints_[line].speed;
    const double braking = 0.1 * 0.1 / (2 * kAcceleration) + 1e-3;  // from the fastest
    if (outside_zones(samples[i].tip, braking) < 0) continue;
    const double measured = (samples[i + 1].tip - samples[i - 1].tip).norm() / (2 * kStep);
    EXPECT_NEAR(measured, speed, 0.02 * speed) << "to waypoint " << line;
    ++looked_at;
  }
  EXPECT_GT(looked_at, 2000u);
}

TEST_F(FollowedPaths, KeepToTheAcceleration) {
  begin();
  const auto samples = all();
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const Vector3d change = samples[i + 1].tip - 2 * samples[i].tip + samples[i - 1].tip;
    // along the path and across it at once
    EXPECT_LT(change.norm() / (kStep * kStep), 1.5 * kAcceleration) << samples[i].time;
  }
}

TEST_F(FollowedPaths, PassEveryWaypointOnceAndInOrder) {
  begin();
  std::uint64_t passed = 0;
  for (const Sample& sample : all()) {
    const auto now = sample.state.waypoint;
    ASSERT_TRUE(now == passed || now == passed + 1);
    if (now == passed) continue;
    passed = now;
    const auto& waypoint = waypoints_[now];
    EXPECT_LT((sample.tip - waypoint.tip.translation()).norm(),
              std::max(waypoint.zone, 0.1 * kStep) + 1e-7);
  }
  EXPECT_EQ(passed + 1, waypoints_.size());
}

TEST_F(FollowedPaths, SwitchTheOutputsAtTheirWaypointsAndOffAtTheEnd) {
  begin();
  const auto samples = all();
  for (const Sample& sample : samples) {
    const bool moving = sample.state.status == MotionStatus::kMoving;
    EXPECT_EQ(sample.state.outputs, moving ? waypoints_[sample.state.waypoint].outputs : 0);
  }
  EXPECT_EQ(samples.back().state.outputs, 0u);
}

TEST_F(FollowedPaths, TurnAboutOneAxisEvenlyAlongALine) {
  begin();
  const Matrix3d from = waypoints_[1].tip.linear();
  for (const Sample& sample : all()) {
    const double along = (sample.tip - waypoints_[1].tip.translation()).y();
    const bool on_second = sample.state.waypoint == 1 && along > 2e-3;
    if (!on_second || along > 0.078) continue;
    const Matrix3d expected = from * AngleAxisd(0.2 * along / 0.08, axis_).toRotationMatrix();
    EXPECT_LT(AngleAxisd(sample.turn.transpose() * expected).angle(), 1e-6);
  }
}

TEST_F(FollowedPaths, GoOnFromTheWaypointThatIsSaid) {
  const auto whole = waypoints_;
  waypoints_.resize(4);
  begin();
  const double end = all().back().time;
  waypoints_ = whole;
  control_.follow(8, tool_, waypoints_, 3, instant(end + 1));
  const Sample first = at(end + 1 + kStep);
  EXPECT_EQ(first.state.waypoint, 3u);
  EXPECT_EQ(first.state.outputs, waypoints_[3].outputs);
  const Sample last = at(end + 30);
  EXPECT_EQ(last.state.status, MotionStatus::kArrived);
  EXPECT_EQ(last.state.waypoint + 1, waypoints_.size());
}

TEST_F(FollowedPaths, BrakeOnThePathWithTheOutputsOffAtOnce) {
  for (const bool emergency : {false, true}) {
    for (double when = 0.2; when < 6; when += 0.37) {
      scan_cell_sim::MotionControl control(scan_cell_sim::Controller::start_posture());
      control.follow(7, tool_, waypoints_, 0, kStart);
      ASSERT_EQ(control.state(instant(when)).status, MotionStatus::kMoving);
      if (emergency) {
        control.press_e_stop(instant(when));
      } else {
        control.stop(std::nullopt, instant(when));
      }
      for (double after = 0; after < 1; after += 0.01) {
        const auto state = control.state(instant(when + after));
        const Vector3d tip = (state.flange * tool_).translation();
        EXPECT_EQ(state.outputs, 0u);
        EXPECT_TRUE(off_the_lines(tip) < 0.05e-3 || outside_zones(tip) < 1e-7);
        EXPECT_TRUE(after < 0.5 || state.status == MotionStatus::kStopped);
      }
      const auto later = control.state(instant(when + 100));
      EXPECT_EQ((later.joints - control.state(instant(when + 1)).joints).norm(), 0);
    }
  }
}

TEST_F(FollowedPaths, FollowTheOverrideAtOnceAndStayOnTheirLines) {
  begin();
  auto settings = control_.settings();
  settings.override = 0.1;
  control_.set(settings, instant(0.6));
  EXPECT_NEAR((at(0.9).tip - at(0.8).tip).norm() / 0.1, 0.005, 1e-4);
  settings.override = 1;
  control_.set(settings, instant(1.0));
  const auto samples = all();
  expect_on_the_path(samples);
  EXPECT_EQ(samples.back().state.status, MotionStatus::kArrived);
}

TEST_F(FollowedPaths, AreSlowInModeProgramming) {
  waypoints_.clear();
  add(0, 300, 0, 1000, 0);
  control_.select(scan_cell_sim::ControllerMode::kProgramming, kStart);
  control_.switch_drives(true, scan_cell_sim::Readiness::Source::kPanel, kStart);
  begin();
  const auto samples = all();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double moved =
        (samples[i].state.flange.translation() - samples[i - 1].state.flange.translation()).norm();
    EXPECT_LT(moved / kStep, 0.25 * 1.001);
  }
}

TEST_F(FollowedPaths, StopForATurnOnTheSpotAndMakeIt) {
  waypoints_.clear();
  add(50, 0, 0, 50, 5);
  add(0, 0, 0, 50, 5, 1, 0.8);
  add(0, 50, 0, 50, 0);
  begin();
  const auto samples = all();
  EXPECT_EQ(samples.back().state.status, MotionStatus::kArrived);
  for (const Sample& sample : samples)
    EXPECT_LT(off_the_lines(sample.tip), 1e-7);
}

TEST_F(FollowedPaths, AreRefusedWhereTheyAreNone) {
  const auto good = waypoints_;
  waypoints_[2] = waypoints_[1];
  EXPECT_EQ(refusal([&] { begin(); }), ControllerErrorCode::kBadPath);
  waypoints_ = good;
  waypoints_[2].tip.linear() = waypoints_[1].tip.linear() * AngleAxisd(M_PI, axis_);
  EXPECT_EQ(refusal([&] { begin(); }), ControllerErrorCode::kBadPath);
  waypoints_ = good;
  waypoints_[0].tip.translation().x() += 0.002;
  EXPECT_EQ(refusal([&] { begin(); }), ControllerErrorCode::kNotAtStart);
  waypoints_ = good;
  EXPECT_EQ(refusal([&] { begin(2); }), ControllerErrorCode::kNotAtStart);
  waypoints_.back().tip.translation().x() += 2;
  EXPECT_EQ(refusal([&] { begin(); }), ControllerErrorCode::kOutOfReach);
  EXPECT_EQ(control_.motions_begun(), 0u);
}

TEST_F(FollowedPaths, OfThousandsOfWaypointsKeepTheirSpeed) {
  waypoints_.clear();
  for (int i = 1; i <= 2000; ++i) {
    const double angle = 0.02 * i;
    add(2 * std::cos(angle), 2 * std::sin(angle), 0, 50, 0.5, i % 2);
  }
  begin();
  const auto samples = all();
  ASSERT_EQ(samples.back().state.status, MotionStatus::kArrived);
  expect_on_the_path(samples);
  // 4 m at 50 mm/s; the corners are flat
  EXPECT_NEAR(samples.back().time, 80, 0.2);
}
