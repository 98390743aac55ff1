// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The thesis' constant speed interpolator (section 6.1), against closed forms.
#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "poses/pose_rule.h"
#include "scan_cell_common/errors/errors.h"
#include "synthetic_scan.h"

using namespace pose_frame_binder;  // NOLINT
using scan_cell_common::InvalidParameter;
using scan_cell_common::Refused;

namespace {

/// 0.5 m along a diagonal, turning by 0.6 rad, at 0.1 m/s and 100 frames/s: 501 frames.
Settings motion() {
  Settings settings;
  settings.method = Method::kConstantSpeed;
  ConstantSpeed& line = settings.constant_speed;
  line.start = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ());
  line.end = Eigen::Translation3d(1.3, 2.4, 3) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  line.speed = 0.1;
  line.frame_rate = 100;
  return settings;
}

/// The motion of each arming is announced.
Settings told() {
  Settings settings = motion();
  settings.constant_speed = {};
  return settings;
}

constexpr double kLate = 0.003;  // [m] from the start to the first pulse

/// 50 pulses along that motion; the robot moves at this share of the speed.
SyntheticScan told_and_measured(double share) {
  SyntheticScan scan = steady_scan(50);
  scan.runs = {{0, motion().constant_speed}};
  for (TimedPose& pose : scan.poses) {
    const double way = kLate + share * 0.1 * scan_cell_common::to_seconds(pose.time - kStart);
    pose.pose.translation() = Eigen::Vector3d(1 + 0.6 * way, 2 + 0.8 * way, 3);
  }
  return scan;
}

Outcome bind(SyntheticScan scan, const Settings& settings) {
  scan.poses.clear();  // none is measured
  return run(scan, settings);
}

std::string complaint(const std::function<void(Settings&)>& change) {
  Settings settings = motion();
  change(settings);
  try {
    Binder binder(settings);
  } catch (const InvalidParameter& error) {
    return error.what();
  }
  return "taken";
}

}  // namespace

TEST(ConstantSpeed, PutsEveryFrameWhereItsNumberSays) {
  const Outcome outcome = bind(steady_scan(501), motion());
  ASSERT_EQ(outcome.audit.frames_bound, 501U);
  EXPECT_EQ(outcome.audit.by_rule[static_cast<int>(Rule::kConstantSpeed)], 501U);
  EXPECT_EQ(outcome.audit.method, Method::kConstantSpeed);
  for (std::size_t i : {0U, 1U, 250U, 500U}) {
    const Match match = outcome.match(i).value();
    const double way = 0.001 * static_cast<double>(i);  // 3-4-5
    const Eigen::Vector3d truth(1 + 0.6 * way, 2 + 0.8 * way, 3);
    EXPECT_LT((match.pose.translation() - truth).norm(), 1e-12);
    const Eigen::AngleAxisd turn(0.1 + 1.2 * way, Eigen::Vector3d::UnitZ());
    EXPECT_LT((match.pose.linear() - turn.toRotationMatrix()).norm(), 1e-12);
    EXPECT_LT(match.position_error_bound, 1e-9);
    EXPECT_TRUE(std::isnan(match.time_to_before));
    EXPECT_TRUE(std::isnan(match.time_to_after));
  }
}

TEST(ConstantSpeed, GoesBackWhereStartAndEndAreSwapped) {
  Settings settings = motion();
  std::swap(settings.constant_speed.start, settings.constant_speed.end);
  const Outcome outcome = bind(steady_scan(101), settings);
  const Eigen::Vector3d truth(1.3 - 0.06, 2.4 - 0.08, 3);
  EXPECT_LT((outcome.match(100)->pose.translation() - truth).norm(), 1e-12);
}

TEST(ConstantSpeed, MovesTheScannerTheOtherWayWhereAConveyorMovesTheObject) {
  Settings settings = motion();
  ConstantSpeed& line = settings.constant_speed;
  line.end.linear() = line.start.linear();
  line.object_moves = true;
  Outcome outcome = bind(steady_scan(101), settings);
  const Eigen::Vector3d truth(1 - 0.06, 2 - 0.08, 3);
  EXPECT_LT((outcome.match(100)->pose.translation() - truth).norm(), 1e-12);
  EXPECT_LT((outcome.match(100)->pose.linear() - line.start.linear()).norm(), 1e-12);

  // An object that also turns: a point seen by the scanner must stay in its place on the object.
  settings = motion();
  settings.constant_speed.object_moves = true;
  outcome = bind(steady_scan(101), settings);
  const Eigen::Isometry3d start = settings.constant_speed.start;
  const Eigen::Isometry3d moved =
      scan_cell_common::interpolate(start, settings.constant_speed.end, 0.2);
  const Eigen::Vector3d seen(0.01, 0.02, 0.4);  // by the scanner, which stands
  const Eigen::Vector3d on_object = (moved * start.inverse()).inverse() * (start * seen);
  EXPECT_LT((outcome.match(100)->pose * seen - on_object).norm(), 1e-12);
}

TEST(ConstantSpeed, KeepsItsPlaceWhereFramesWereLost) {
  SyntheticScan scan = steady_scan(100);
  scan.frames.erase(scan.frames.begin() + 10, scan.frames.begin() + 40);
  scan.truth.erase(scan.truth.begin() + 10, scan.truth.begin() + 40);
  const Outcome outcome = bind(scan, motion());
  EXPECT_EQ(outcome.audit.frames_bound, 70U);
  EXPECT_NEAR(outcome.match(10)->pose.translation().x(), 1 + 0.6 * 0.040, 1e-12);
}

TEST(ConstantSpeed, DropsFramesBehindTheEnd) {
  const Outcome outcome = bind(steady_scan(520), motion());
  EXPECT_EQ(outcome.audit.frames_bound, 501U);
  EXPECT_EQ(outcome.dropped(DropReason::kNoPoseAfter), 19U);
}

TEST(ConstantSpeed, SaysHowFarAnUnsteadyFrameRatePutsItOff) {
  SyntheticScan scan = steady_scan(50);
  for (std::size_t i = 25; i < 50; ++i) {  // a pulse was left out
    scan.pulses[i].time += 10 * kMillisecond;
    scan.frames[i].stamp += 10 * kMillisecond;
  }
  Outcome outcome = bind(scan, motion());
  EXPECT_NEAR(outcome.match(10)->position_error_bound, 0, 1e-9);
  EXPECT_NEAR(outcome.match(30)->position_error_bound, 0.001, 1e-9);
  EXPECT_NEAR(outcome.audit.worst_position_error, 0.001, 1e-9);
  Settings strict = motion();
  strict.max_pose_gap = 0.005;
  outcome = bind(scan, strict);
  EXPECT_EQ(outcome.dropped(DropReason::kPoseGap), 25U);
}

TEST(ConstantSpeed, SaysNothingOfASecondArming) {
  const SyntheticScan scan = armed_twice();
  const Outcome outcome = bind(scan, motion());
  EXPECT_EQ(outcome.audit.frames_bound, 30U);
  EXPECT_EQ(outcome.dropped(DropReason::kNoPoseBefore), 30U);
}

TEST(ConstantSpeed, FollowsTheMotionThatItIsToldOfEachArming) {
  const Settings settings = told();
  const ConstantSpeed there = motion().constant_speed;
  ConstantSpeed back = there;
  std::swap(back.start, back.end);
  SyntheticScan scan = armed_twice();
  scan.runs = {{0, there}, {7, back}};
  std::size_t bound = 0;
  for (const Decision& decision : bind(scan, settings).decisions) {
    if (!decision.match) continue;
    ++bound;
    const Match& match = *decision.match;
    const double way = 0.001 * static_cast<double>(match.pulse.count - 1);
    const bool second = match.pulse.arming != scan.pulses.front().arming;
    EXPECT_EQ(match.pass, second ? 7U : 0U);
    EXPECT_NEAR(match.pose.translation().x(), second ? 1.3 - 0.6 * way : 1 + 0.6 * way, 1e-12);
  }
  EXPECT_EQ(bound, 60U);
}

TEST(ConstantSpeed, PutsTheFirstPulseOfAnArmingWhereTheRobotWasMeasured) {
  SyntheticScan scan = told_and_measured(1);
  const Outcome outcome = run(scan, told());
  ASSERT_EQ(outcome.audit.frames_bound, 50U);
  for (std::size_t i : {0U, 1U, 49U}) {
    const Match match = outcome.match(i).value();
    const double way = kLate + 0.001 * static_cast<double>(i);
    EXPECT_NEAR(match.pose.translation().x(), 1 + 0.6 * way, 1e-9);
    EXPECT_NEAR(match.pose.translation().y(), 2 + 0.8 * way, 1e-9);
    EXPECT_LT(match.position_error_bound, 1e-9);
  }
}

TEST(ConstantSpeed, KnowsWhereTheRobotIsWhereATriggerLeavesPulsesOut) {
  SyntheticScan scan = alternating_scan(30);
  scan.poses.clear();
  scan.runs = {{0, motion().constant_speed}};
  const Outcome outcome = run(scan, told());
  ASSERT_EQ(outcome.audit.frames_bound, 30U);
  // Its first four intervals have two periods.
  EXPECT_NEAR(outcome.match(1)->pose.translation().x(), 1 + 0.6 * 0.002, 1e-9);
  EXPECT_NEAR(outcome.match(29)->pose.translation().x(), 1 + 0.6 * 0.033, 1e-9);
}

TEST(ConstantSpeed, SaysHowFarTheRobotWasFromWhereItIsPut) {
  const Outcome outcome = run(told_and_measured(0.96), told());
  ASSERT_EQ(outcome.audit.frames_bound, 50U);
  EXPECT_NEAR(outcome.match(10)->position_error_bound, 0.04 * 0.010, 1e-9);
  EXPECT_NEAR(outcome.audit.worst_position_error, 0.04 * 0.049, 1e-9);
}

TEST(ConstantSpeed, DropsFramesWhereTheRobotDidNotMoveAsFastAsItWasTold) {
  // It falls back by 0.52 mm per pulse; max_pose_gap corresponds to 5 mm.
  const Outcome outcome = run(told_and_measured(0.48), told());
  EXPECT_EQ(outcome.audit.frames_bound, 10U);
  EXPECT_EQ(outcome.dropped(DropReason::kPoseGap), 40U);
}

TEST(ConstantSpeed, RefusesAnArmingThatIsNoLine) {
  Binder binder(told());
  try {
    binder.start_run({3, std::nullopt});
    ADD_FAILURE() << "taken";
  } catch (const Refused& refusal) {
    EXPECT_EQ(std::string(refusal.what()).find("pass 4: an arc or a polyline"), 0U);
  }
  EXPECT_NO_THROW(check(pose_frame_binder::Run{0, std::nullopt}, motion()))
      << "the settings give the motion";
  EXPECT_NO_THROW(check(pose_frame_binder::Run{3, std::nullopt}, {})) << "another method";
}

TEST(ConstantSpeed, RefusesASecondArmingWhereTheSettingsGiveTheMotion) {
  EXPECT_THROW(check(pose_frame_binder::Run{1, motion().constant_speed}, motion()), Refused);
  Binder binder(motion());
  EXPECT_NO_THROW(binder.start_run({0, std::nullopt}));
  EXPECT_THROW(binder.start_run({0, std::nullopt}), Refused) << "the same pass with another laser";
}

TEST(ConstantSpeed, RefusesPulsesWhoseMotionNobodyTold) {
  Binder binder(told());
  EXPECT_THROW(binder.add_pulse({kStart, 1, 1, 1}), Refused);
}

TEST(ConstantSpeed, RefusesAnArmingWhoseMotionIsNotDetermined) {
  ConstantSpeed nowhere = motion().constant_speed;
  nowhere.end = nowhere.start;
  EXPECT_THROW(Binder(told()).start_run({0, nowhere}), InvalidParameter);
}

TEST(ConstantSpeed, RefusesAMotionThatIsNotDetermined) {
  const auto says = [](const char* words, const std::function<void(ConstantSpeed&)>& change) {
    const std::string text = complaint([&](Settings& s) { change(s.constant_speed); });
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  says("missing, or not poses", [](ConstantSpeed& m) {
    m = ConstantSpeed{ConstantSpeed::none(), m.end, 1, 1};
  });
  says("constant_speed/speed", [](ConstantSpeed& m) { m.speed = 0; });
  says("constant_speed/speed", [](ConstantSpeed& m) { m.speed = -0.1; });
  says("constant_speed/speed", [](ConstantSpeed& m) { m.speed = NAN; });
  says("constant_speed/frame_rate", [](ConstantSpeed& m) { m.frame_rate = INFINITY; });
  says("at the same position",
       [](ConstantSpeed& m) { m.end.translation() = m.start.translation(); });
  says("half a turn apart", [](ConstantSpeed& m) {
    m.end.linear() = m.start.linear() * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
  });
  EXPECT_EQ(complaint([](Settings& s) {
              s.constant_speed = {};
              s.method = Method::kInterpolate;
            }),
            "taken");
}
