// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <future>
#include <random>
#include <vector>

#include "controller/arm/wire_pose.h"
#include "controller/arm_truth.h"
#include "controller/motion/motion_control.h"

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;
using scan_cell_common::from_seconds;
using scan_cell_common::Nanoseconds;
using scan_cell_sim::ControllerErrorCode;
using scan_cell_sim::ControllerMode;
using scan_cell_sim::Joints;
using scan_cell_sim::MotionControl;
using scan_cell_sim::MotionStatus;
using scan_cell_sim::SpeedProfile;
using Source = scan_cell_sim::Readiness::Source;

namespace {

class Motion : public testing::Test {
 protected:
  scan_cell_sim::MotionState at(double seconds) const {
    return control_.state(kStart + from_seconds(seconds));
  }

  Isometry3d start_ = looking_down(0.80, 0, 0.60);
  MotionControl control_{scan_cell_sim::reach(start_, Joints::Zero())};
};

}  // namespace

TEST(SpeedProfile, TakesTheTimeOfTheTrapezoidsClosedForm) {
  const double way = 0.4, speed = 0.25, acceleration = 1.0;
  const SpeedProfile profile = SpeedProfile::trapezoid(0, way, 0, speed, acceleration);
  EXPECT_NEAR(profile.duration(), way / speed + speed / acceleration, 1e-12);
  EXPECT_NEAR(profile.position(0.25), 0.03125, 1e-12);  // v^2 / 2a
  EXPECT_NEAR(profile.position(0.85), 0.03125 + 0.25 * 0.6, 1e-12);
  EXPECT_NEAR(profile.speed(0.85), speed, 1e-12);
  EXPECT_EQ(profile.position(99), way);
  EXPECT_EQ(profile.position(-1), 0);
}

TEST(SpeedProfile, IsATriangleWhereTheWayIsShort) {
  const SpeedProfile profile = SpeedProfile::trapezoid(0, 0.01, 0, 0.25, 1.0);
  EXPECT_NEAR(profile.duration(), 2 * std::sqrt(0.01 / 1.0), 1e-12);
  EXPECT_NEAR(profile.speed(0.1), std::sqrt(0.01), 1e-12);
}

TEST(SpeedProfile, BrakesOverTheSquareOfTheSpeed) {
  const SpeedProfile profile = SpeedProfile::brake(0.3, 0.25, 1.0);
  EXPECT_NEAR(profile.end(), 0.3 + 0.25 * 0.25 / 2, 1e-12);
  EXPECT_NEAR(profile.duration(), 0.25, 1e-12);
}

TEST(SpeedProfile, SlowsDownToALowerSpeedAndStillEndsThere) {
  const SpeedProfile profile = SpeedProfile::trapezoid(0.1, 1.0, 0.5, 0.2, 0.5);
  EXPECT_NEAR(profile.speed(0.6), 0.2, 1e-12);
  EXPECT_EQ(profile.position(profile.duration() + 1e-9), 1.0);
  EXPECT_NEAR(profile.position(profile.duration() - 1e-9), 1.0, 1e-9);
}

TEST(Kinematics, AgreesWithTheProductOfExponentials) {
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    Joints joints;
    for (int axis = 0; axis < 6; ++axis)
      joints[axis] =
          std::uniform_real_distribution<double>(scan_cell_sim::joint_limits().lower[axis],
                                                 scan_cell_sim::joint_limits().upper[axis])(random);
    expect_same(scan_cell_sim::flange_of(joints), product_of_exponentials(joints), 1e-9);
  }
}

TEST(Kinematics, AnswersEachOfSeveralThreadsForItsOwnJoints) {
  const auto right_of = [](const Joints& joints) {
    constexpr int kTimes = 50000;
    const Eigen::Isometry3d flange = product_of_exponentials(joints);
    int right = 0;
    for (int i = 0; i < kTimes; ++i)
      right += scan_cell_sim::flange_of(joints).isApprox(flange, 1e-9);
    return right == kTimes;
  };
  std::vector<std::future<bool>> threads(4);
  for (std::size_t i = 0; i < threads.size(); ++i) {
    const Joints joints = degrees(10, 20, -80, 30, 40, 50) * (1 - 0.2 * static_cast<double>(i));
    threads[i] = std::async(std::launch::async, right_of, joints);
  }
  for (auto& thread : threads)
    EXPECT_TRUE(thread.get());
}

TEST(Kinematics, LooksDownWithTheForearmLevelAndTheWristBent) {
  // by hand: x = a1 + d4, z = d1 + a2 + a3 - d6
  expect_same(scan_cell_sim::flange_of(degrees(0, 0, -90, 0, 90, 0)),
              looking_down(0.150 + 0.64707, 0, 0.450 + 0.590 + 0.130 - 0.095), 1e-12);
}

TEST(Kinematics, TurnsWithComausSigns) {
  const Isometry3d home = scan_cell_sim::flange_of(degrees(0, 0, -90, 0, 90, 0));
  const Isometry3d left = scan_cell_sim::flange_of(degrees(-30, 0, -90, 0, 90, 0));
  EXPECT_GT(left.translation().y(), 0.3);  // J1 turns about -z
  const Isometry3d forward = scan_cell_sim::flange_of(degrees(0, 20, -90, 0, 90, 0));
  EXPECT_GT(forward.translation().x(), home.translation().x());  // J2 leans forward
  const Isometry3d up = scan_cell_sim::flange_of(degrees(0, 0, -60, 0, 90, 0));
  EXPECT_GT(up.translation().z(), home.translation().z());  // J3 lifts the forearm towards 0
}

TEST(Kinematics, ReachesEveryPoseOfTheScanningSpace) {
  const Joints start = scan_cell_sim::reach(looking_down(0.80, 0, 0.60), Joints::Zero());
  for (double x = 0.55; x < 1.11; x += 0.055) {
    for (double y = -0.35; y < 0.36; y += 0.07) {
      for (double z = 0.4; z < 0.91; z += 0.1) {
        const Joints joints = scan_cell_sim::reach(looking_down(x, y, z), start);
        expect_same(product_of_exponentials(joints), looking_down(x, y, z), 2e-9);
        EXPECT_GT(joints[4], 20 * kDegree) << "the wrist must stay on its side";
      }
    }
  }
}

TEST(WirePose, IsEulerZyzInMillimetresAndDegrees) {
  // the table of c4g_protocol.md
  const Isometry3d down_along_y =
      Isometry3d(AngleAxisd(M_PI / 2, Vector3d::UnitZ())) * looking_down(0, 0, 0);
  expect_same(scan_cell_sim::pose_from_wire({0, 0, 0, 0, 180, 90}), down_along_y, 1e-12);
  expect_same(scan_cell_sim::pose_from_wire({0, 0, 0, 0, 180, 180}), looking_down(0, 0, 0), 1e-12);
  expect_same(scan_cell_sim::pose_from_wire({0, 0, 0, 90, 180, -90}), looking_down(0, 0, 0), 1e-12);
  expect_same(scan_cell_sim::pose_from_wire({800, -20, 600, 33, 44, 55}),
              Translation3d(0.8, -0.02, 0.6) * AngleAxisd(33 * kDegree, Vector3d::UnitZ()) *
                  AngleAxisd(44 * kDegree, Vector3d::UnitY()) *
                  AngleAxisd(55 * kDegree, Vector3d::UnitZ()),
              1e-12);
}

TEST(WirePose, ComesBackAlsoWhereOnlyTheSumOfTwoAnglesIsDefined) {
  for (const double e : {0.0, 1e-5, 30.0, 90.0, 179.9999, 180.0}) {
    const Isometry3d pose = scan_cell_sim::pose_from_wire({1, 2, 3, 20, e, -130});
    expect_same(scan_cell_sim::pose_from_wire(scan_cell_sim::to_wire(pose)), pose, 3e-6);
  }
}

TEST_F(Motion, RunsALineStraightAtTheSpeedAskedFor) {
  const Isometry3d end = looking_down(0.80, 0.30, 0.55);
  control_.move_to_pose(7, end, 100, kStart);
  const double way = (end.translation() - start_.translation()).norm();
  const double duration = way / 0.25 + 0.25;  // defaults: 0.25 m/s, 1 m/s^2
  const Vector3d direction = (end.translation() - start_.translation()) / way;
  for (double time = 0; time < duration; time += 0.01) {
    const auto state = at(time);
    const Vector3d passed = state.flange.translation() - start_.translation();
    EXPECT_LT(passed.cross(direction).norm(), 1e-9);
    expect_same(product_of_exponentials(state.joints), state.flange, 3e-9);
    EXPECT_EQ(state.status, MotionStatus::kMoving);
    if (time > 0.3 && time < duration - 0.3) {
      const Vector3d step = at(time + 0.01).flange.translation() - state.flange.translation();
      EXPECT_NEAR(step.norm(), 0.0025, 1e-8);
    }
  }
  EXPECT_EQ(at(duration - 0.001).status, MotionStatus::kMoving);
  EXPECT_EQ(at(duration + 0.001).status, MotionStatus::kArrived);
  EXPECT_EQ(at(duration + 0.001).motion, 7u);
  expect_same(at(duration + 0.001).flange, end, 1e-9);
}

TEST_F(Motion, TurnsAlongALineAboutOneAxis) {
  Isometry3d end = looking_down(0.80, 0.10, 0.60);
  end.rotate(AngleAxisd(0.4, Vector3d(1, 2, 3).normalized()));
  control_.move_to_pose(1, end, 0, kStart);
  for (double time = 0.05; time < 0.6; time += 0.05) {
    const auto state = at(time);
    const AngleAxisd turned(start_.linear().transpose() * state.flange.linear());
    EXPECT_NEAR(turned.angle(), 0.4 * state.progress, 1e-9);
    EXPECT_LT(turned.axis().cross(Vector3d(1, 2, 3).normalized()).norm(), 1e-6);
  }
}

TEST_F(Motion, MovesAllAxesTogetherAndTheSlowestAtItsSpeed) {
  const Joints from = at(0).joints;
  Joints to = from;
  to[0] += 90 * kDegree;
  to[5] += 45 * kDegree;
  control_.move_to_joints(1, to, 0, kStart);
  const double duration = 90.0 / 140 + 0.25;  // J1: 140 deg/s, full speed in a quarter of a second
  for (double time = 0; time < duration; time += 0.02) {
    const Joints passed = at(time).joints - from;
    EXPECT_NEAR(passed[0], 2 * passed[5], 1e-9);
    EXPECT_NEAR(passed[1], 0, 1e-12);
  }
  EXPECT_NEAR((at(0.5).joints[0] - at(0.4).joints[0]) / 0.1, 140 * kDegree, 1e-6);
  EXPECT_EQ(at(duration - 0.001).status, MotionStatus::kMoving);
  EXPECT_EQ(at(duration + 0.001).status, MotionStatus::kArrived);
}

TEST_F(Motion, TakesTheOverrideAtOnce) {
  auto settings = control_.settings();
  control_.move_to_pose(1, looking_down(0.80, 0.30, 0.60), 0, kStart);
  settings.override = 0.2;
  control_.set(settings, kStart + from_seconds(0.5));
  const auto speed = [this](double time) {
    return (at(time + 0.01).flange.translation() - at(time).flange.translation()).norm() / 0.01;
  };
  EXPECT_NEAR(speed(0.45), 0.25, 1e-6);
  EXPECT_NEAR(speed(0.50 + 0.2 + 0.01), 0.05, 1e-6);  // 0.2 m/s less at 1 m/s^2
  EXPECT_EQ(at(10).status, MotionStatus::kArrived);
  expect_same(at(10).flange, looking_down(0.80, 0.30, 0.60), 1e-9);
}

TEST_F(Motion, BrakesOnItsPathAndStaysStopped) {
  control_.move_to_pose(1, looking_down(0.80, 0.30, 0.60), 0, kStart);
  control_.stop(std::nullopt, kStart + from_seconds(0.5));
  const double stopped_at = 0.25 * 0.5 - 0.03125 + 0.03125;  // cruise, and as long to brake
  EXPECT_EQ(at(0.74).status, MotionStatus::kMoving);
  EXPECT_EQ(at(0.76).status, MotionStatus::kStopped);
  EXPECT_NEAR(at(100).flange.translation().y(), stopped_at, 1e-9);
}

TEST_F(Motion, DoesNotGoOnAfterAnEmergencyStop) {
  control_.move_to_pose(1, looking_down(0.80, 0.30, 0.60), 0, kStart);
  control_.press_e_stop(kStart + from_seconds(0.5));
  const auto stopped = at(0.6);
  EXPECT_EQ(stopped.status, MotionStatus::kStopped);
  EXPECT_EQ(stopped.why->code, ControllerErrorCode::kEmergencyStop);
  EXPECT_EQ(
      refusal([this] { control_.move_to_joints(2, at(0).joints, 0, kStart + 1'000'000'000); }),
      ControllerErrorCode::kEmergencyStop);
  control_.release_e_stop();
  control_.reset_alarms(Source::kClient);
  control_.switch_drives(true, Source::kClient, kStart + 2'000'000'000);
  expect_same(at(20).flange, stopped.flange, 1e-12);
  EXPECT_EQ(at(20).status, MotionStatus::kStopped);
}

TEST_F(Motion, StaysWithin250MillimetresASecondInModeProgramming) {
  auto settings = control_.settings();
  settings.line.speed = 1.5;
  control_.set(settings, kStart);
  control_.select(ControllerMode::kProgramming, kStart);
  control_.switch_drives(true, Source::kPanel, kStart);
  const auto fastest = [this](double from) {
    double speed = 0;
    for (double time = from; at(time).status == MotionStatus::kMoving; time += 0.01) {
      const Vector3d way = at(time + 0.01).flange.translation() - at(time).flange.translation();
      speed = std::max(speed, way.norm() / 0.01);
    }
    return speed;
  };
  control_.move_to_pose(1, looking_down(0.80, 0.30, 0.60), 0, kStart);
  EXPECT_NEAR(fastest(0), 0.25, 1e-4);
  Joints far = at(100).joints;
  far[0] += 120 * kDegree;
  far[1] -= 30 * kDegree;
  control_.move_to_joints(2, far, 0, kStart + from_seconds(100));
  EXPECT_NEAR(fastest(100), 0.25, 1e-4);
}

TEST_F(Motion, EndsForGoodWhenTheEnablingDeviceIsReleased) {
  control_.select(ControllerMode::kProgramming, kStart);
  EXPECT_EQ(refusal([this] { control_.move_to_joints(1, at(0).joints, 0, kStart); }),
            ControllerErrorCode::kEmergencyStop)
      << "another mode switches the drives off";
  control_.switch_drives(true, Source::kPanel, kStart);
  control_.move_to_pose(1, looking_down(0.80, 0.30, 0.60), 0, kStart);
  control_.switch_drives(false, Source::kPanel, kStart + from_seconds(0.5));
  EXPECT_EQ(at(0.6).status, MotionStatus::kStopped);
  EXPECT_EQ(at(0.6).why->code, ControllerErrorCode::kEmergencyStop);
  control_.switch_drives(true, Source::kPanel, kStart + from_seconds(1));
  expect_same(at(20).flange, at(0.6).flange, 1e-12);
}

TEST_F(Motion, EndsWhenAnotherModeIsSelected) {
  control_.move_to_pose(1, looking_down(0.80, 0.30, 0.60), 0, kStart);
  control_.select(ControllerMode::kAutomatic, kStart + from_seconds(0.5));
  EXPECT_EQ(at(0.6).status, MotionStatus::kStopped);
  EXPECT_EQ(at(0.6).why->code, ControllerErrorCode::kMode);
  control_.switch_drives(true, Source::kPanel, kStart + from_seconds(1));
  EXPECT_EQ(refusal([this] { control_.move_to_joints(2, at(0).joints, 0, kStart + 2000000000); }),
            ControllerErrorCode::kMode);
}

TEST_F(Motion, EndsWithAnAlarmThatStandsUntilItIsReset) {
  control_.move_to_pose(1, looking_down(0.80, 0.30, 0.60), 0, kStart);
  control_.fail("following error of J2", kStart + from_seconds(0.5));
  EXPECT_EQ(at(0.6).status, MotionStatus::kError);
  ASSERT_EQ(at(0.6).readiness.alarms().size(), 1u);
  EXPECT_EQ(at(0.6).readiness.alarms().front().text, "following error of J2");
  EXPECT_FALSE(at(0.6).readiness.drives());
  const auto move = [this] { control_.move_to_joints(2, at(0).joints, 0, kStart + 1000000000); };
  EXPECT_EQ(refusal(move), ControllerErrorCode::kAlarm);
  EXPECT_EQ(refusal([this] { control_.switch_drives(true, Source::kClient, kStart); }),
            ControllerErrorCode::kAlarm);
  control_.reset_alarms(Source::kClient);
  EXPECT_EQ(refusal(move), ControllerErrorCode::kEmergencyStop) << "the drives are off still";
  control_.switch_drives(true, Source::kClient, kStart);
  EXPECT_NO_THROW(move());
}

TEST(Readiness, KeepsTheFirstAlarmAndTheNewest) {
  scan_cell_sim::Readiness readiness;
  for (int i = 0; i < 20; ++i)
    readiness.raise({ControllerErrorCode::kMotionFailed, std::to_string(i)});
  ASSERT_EQ(readiness.alarms().size(), 4u);
  EXPECT_EQ(readiness.alarms().front().text, "0");
  EXPECT_EQ(readiness.alarms().back().text, "19");
}

TEST_F(Motion, RefusesWhatTheRobotCannotDo) {
  const auto to_pose = [this](const Isometry3d& pose) {
    return refusal([&] { control_.move_to_pose(1, pose, 0, kStart); });
  };
  EXPECT_EQ(to_pose(looking_down(3, 0, 0.6)), ControllerErrorCode::kOutOfReach);
  Joints beyond = at(0).joints;
  beyond[2] = 5 * kDegree;
  EXPECT_EQ(refusal([&] { control_.move_to_joints(1, beyond, 0, kStart); }),
            ControllerErrorCode::kJointLimit);
  control_.move_to_pose(1, looking_down(0.80, 0.30, 0.60), 0, kStart);
  EXPECT_EQ(refusal([&] { control_.move_to_joints(2, at(0).joints, 0, kStart + 1000); }),
            ControllerErrorCode::kMoving);
  EXPECT_EQ(control_.motions_begun(), 1u);
}

TEST_F(Motion, RemembersWhereItWas) {
  control_.move_to_pose(1, looking_down(0.80, 0.30, 0.60), 0, kStart);
  control_.move_to_pose(2, looking_down(0.90, 0.30, 0.60), 0, kStart + from_seconds(5));
  const auto run = control_.log().at(kStart + from_seconds(0.5));
  EXPECT_NEAR(run.path->flange(run.way(kStart + from_seconds(0.5))).translation().y(),
              0.25 * 0.5 - 0.03125, 1e-9);
  const auto before = control_.log().at(kStart - 1);
  expect_same(before.path->flange(before.way(kStart - 1)), start_, 1e-9);
}
