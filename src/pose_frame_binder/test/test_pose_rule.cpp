// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The thesis' three cases (section 6.2), and interpolation against closed forms.
#include <gtest/gtest.h>

#include "poses/pose_rule.h"
#include "scan_cell_common/errors/errors.h"
#include "synthetic_scan.h"

using namespace pose_frame_binder;  // NOLINT

namespace {

/// Poses and pulses at these times [ms]; the n-th pose has x = n.
class Rules : public testing::Test {
 protected:
  void have(const std::vector<double>& poses, const std::vector<double>& pulses) {
    for (std::size_t i = 0; i < poses.size(); ++i)
      poses_.add(pose_at(poses[i], static_cast<double>(i)));
    for (std::size_t i = 0; i < pulses.size(); ++i)
      pulses_.add({at(pulses[i]), 1, i + 1, 1});
    poses_.end();
    pulses_.end();
  }

  PoseAnswer answer(std::size_t pulse) const {
    return make_pose_rule(settings_)->find(pulse, pulses_, poses_).value();
  }
  /// Number of the pulse's pose; -1: none.
  double pose_of(std::size_t pulse) const {
    const PoseAnswer found = answer(pulse);
    return found.match ? found.match->pose.translation().x() : -1;
  }

  Settings settings_;
  PoseLog poses_{20 * kMillisecond, 1000};
  PulseLog pulses_;
};

class FirstPose : public Rules {
 protected:
  void SetUp() override { settings_.method = Method::kFirstPose; }
};

}  // namespace

TEST_F(FirstPose, PairsOneToOneWhereTheyAlternate) {
  have({0, 10, 20, 30}, {1, 11, 21, 31});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(pose_of(i), static_cast<double>(i));
    EXPECT_EQ(answer(i).match->rule, Rule::kOneToOne);
    EXPECT_NEAR(answer(i).match->time_to_before, 1e-3, 1e-12);
    EXPECT_TRUE(std::isnan(answer(i).match->time_to_after));
  }
}

TEST_F(FirstPose, OfSeveralFramesOnOnePoseTheLowestKeepsIt) {
  have({0, 10, 20}, {1, 4, 7, 11, 14, 17});
  EXPECT_EQ(pose_of(0), 0);
  EXPECT_EQ(pose_of(3), 1);
  EXPECT_EQ(answer(0).match->rule, Rule::kFramesSharePose);
  EXPECT_EQ(answer(3).match->rule, Rule::kFramesSharePose);
  for (const std::size_t other : {1U, 2U, 4U, 5U}) {
    EXPECT_FALSE(answer(other).match);
    EXPECT_EQ(answer(other).reason, DropReason::kSharedPose);
  }
}

TEST_F(FirstPose, OfSeveralPosesOnOneFrameTheFirstKeepsIt) {
  have({0, 2, 4, 6, 8, 10, 12, 14, 16, 18}, {1, 11});
  EXPECT_EQ(pose_of(0), 1);
  EXPECT_EQ(pose_of(1), 6);
  EXPECT_EQ(answer(0).match->rule, Rule::kPosesShareFrame);
  EXPECT_NEAR(answer(0).match->time_to_after, 1e-3, 1e-12);
  EXPECT_TRUE(std::isnan(answer(0).match->time_to_before));
}

TEST_F(FirstPose, GivesNoPoseToTwoFramesWhereTheCasesMix) {
  have({0, 2, 4, 20, 22, 40}, {5, 8, 11, 25, 28});
  std::map<double, int> uses;
  for (std::size_t i = 0; i < 5; ++i)
    if (pose_of(i) >= 0) ++uses[pose_of(i)];
  for (const auto& [pose, count] : uses)
    EXPECT_EQ(count, 1) << "pose " << pose;
  EXPECT_EQ(pose_of(0), 2);  // lowest of the three after the pose at 4 ms
  EXPECT_EQ(answer(1).reason, DropReason::kSharedPose);
  EXPECT_EQ(pose_of(2), 3);  // two poses before the next pulse: the first
  EXPECT_EQ(pose_of(3), 4);
  EXPECT_EQ(answer(4).reason, DropReason::kSharedPose);
}

TEST_F(FirstPose, TakesThePoseAtTheVeryInstantOfThePulse) {
  have({0, 10, 20}, {0, 10, 20});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pose_of(i), static_cast<double>(i));
    EXPECT_EQ(answer(i).match->position_error_bound, 0);
  }
}

TEST_F(FirstPose, RefusesWhatHasNoPoseBeforeOrOneTooFarAway) {
  have({100, 300}, {50, 250, 350});
  EXPECT_EQ(answer(0).reason, DropReason::kNoPoseBefore);
  EXPECT_EQ(answer(1).reason, DropReason::kPoseGap);
}

TEST_F(FirstPose, BoundsItsErrorByTheWayToTheNextPose) {
  have({0, 10, 20}, {1, 11, 21});
  // 1 m in 10 ms from pose to pose: 0.1 m after 1 ms, and a t (T - t) / 2 = 45 um on top.
  EXPECT_NEAR(answer(0).match->position_error_bound, 0.1 + 10.0 / 2 * 1e-3 * 9e-3, 1e-9);
  // Nothing after the last pose: max_speed.
  EXPECT_NEAR(answer(2).match->position_error_bound, settings_.max_speed * 1e-3, 1e-9);
}

TEST_F(Rules, InterpolationFollowsACircleWithinItsBound) {
  constexpr double kRadius = 0.3;
  constexpr double kTurn = 2;  // [rad/s]; acceleration = radius * turn^2
  settings_.max_acceleration = kRadius * kTurn * kTurn;
  const auto on_circle = [=](double milliseconds) {
    TimedPose pose;
    pose.time = at(milliseconds);
    const double angle = kTurn * milliseconds / 1000;
    pose.pose =
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(kRadius, 0, 0.5);
    return pose;
  };
  for (double t = 0; t <= 400; t += 8)
    poses_.add(on_circle(t));
  for (double t = 3; t < 390; t += 7.3)
    pulses_.add({at(t), 1, static_cast<std::uint64_t>(pulses_.size() + 1), 1});
  poses_.end();
  pulses_.end();
  double worst_share = 0;
  for (std::size_t i = 0; i < pulses_.size(); ++i) {
    const Match match = answer(i).match.value();
    const TimedPose truth = on_circle(static_cast<double>(pulses_[i].time - kStart) / kMillisecond);
    const double error = (match.pose.translation() - truth.pose.translation()).norm();
    EXPECT_LE(error, match.position_error_bound * 1.0001 + 1e-12);
    EXPECT_LE(match.position_error_bound, settings_.max_acceleration * 8e-3 * 8e-3 / 8 + 1e-12);
    EXPECT_LT(Eigen::AngleAxisd(match.pose.linear().transpose() * truth.pose.linear()).angle(),
              1e-9);
    worst_share = std::max(worst_share, error / (match.position_error_bound + 1e-12));
  }
  EXPECT_GT(worst_share, 0.9) << "the bound is far from what happens";
}

TEST_F(Rules, InterpolationRefusesAGapAndNeverLeavesTheLog) {
  have({0, 10, 200, 210}, {-5, 5, 100, 205, 215});
  EXPECT_EQ(answer(0).reason, DropReason::kNoPoseBefore);
  EXPECT_NEAR(pose_of(1), 0.5, 1e-9);
  EXPECT_EQ(answer(2).reason, DropReason::kPoseGap);
  EXPECT_NEAR(pose_of(3), 2.5, 1e-9);
  EXPECT_EQ(answer(4).reason, DropReason::kNoPoseAfter);
}

TEST(PoseLog, SortsDropsRepeatedAndLatePosesAndCountsThem) {
  PoseLog log(20 * kMillisecond, 1000);
  for (const double t : {0.0, 20.0, 10.0, 20.0, 30.0, 5.0})
    log.add(pose_at(t, t));
  TimedPose broken = pose_at(40, 0);
  broken.pose.translation().x() = std::nan("");
  log.add(broken);
  ASSERT_EQ(log.size(), 4U);
  for (std::size_t i = 0; i < log.size(); ++i)
    EXPECT_EQ(log[i].time, at(10.0 * static_cast<double>(i)));
  EXPECT_EQ(log.repeated(), 1U);
  EXPECT_EQ(log.late(), 1U);
  EXPECT_EQ(log.unusable(), 1U);
}

TEST(PoseLog, RefusesMoreThanItMayHold) {
  PoseLog log(0, 2);
  log.add(pose_at(0, 0));
  log.add(pose_at(1, 0));
  EXPECT_THROW(log.add(pose_at(2, 0)), scan_cell_common::Refused);
}
