// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "c4g_driver/goal.h"
#include "link/sequence_monitor.h"

using c4g_driver::Goal;
using c4g_driver::MotionStatus;
using c4g_driver::RobotState;
using c4g_driver::SequenceMonitor;
using Verdict = SequenceMonitor::Verdict;

namespace {

RobotState state(MotionStatus status, std::uint64_t motion = 5) {
  RobotState result;
  result.status = status;
  result.motion = motion;
  result.progress = 0.5;
  return result;
}

Goal underway() {
  return {5, Eigen::Isometry3d::Identity(), {}};
}

}  // namespace

TEST(Goal, IsReachedOnlyWhereTheRobotIsMeasuredThere) {
  Goal reached = underway();
  reached.update(state(MotionStatus::kMoving));
  EXPECT_TRUE(reached.underway());
  EXPECT_EQ(reached.progress(), 0.5);
  reached.update(state(MotionStatus::kArrived));
  EXPECT_EQ(reached.outcome(), Goal::Outcome::kReached);

  Goal missed = underway();
  RobotState elsewhere = state(MotionStatus::kArrived);
  elsewhere.flange.translation().x() = 0.002;
  missed.update(elsewhere);
  EXPECT_EQ(missed.outcome(), Goal::Outcome::kFailed);
  EXPECT_NE(missed.message().find("0.002 m"), std::string::npos);

  Goal turned(5, c4g_driver::Joints(c4g_driver::Joints::Constant(0.01)), {});
  turned.update(state(MotionStatus::kArrived));
  EXPECT_EQ(turned.outcome(), Goal::Outcome::kFailed);
}

TEST(Goal, StaysEnded) {
  Goal goal = underway();
  goal.end(Goal::Outcome::kLinkLost, "cable");
  goal.update(state(MotionStatus::kArrived));
  goal.end(Goal::Outcome::kReached, "");
  EXPECT_EQ(goal.outcome(), Goal::Outcome::kLinkLost);
  EXPECT_EQ(goal.message(), "cable");
}

TEST(Goal, IgnoresOtherMotions) {
  Goal goal = underway();
  goal.update(state(MotionStatus::kArrived, 4));
  goal.update(state(MotionStatus::kStopped, 0));
  EXPECT_TRUE(goal.underway());
}

TEST(Goal, SaysWhyItWasStopped) {
  Goal goal = underway();
  RobotState stopped = state(MotionStatus::kStopped);
  stopped.error = c4g_driver::ControllerError{11, "emergency stop"};
  goal.update(stopped);
  EXPECT_EQ(goal.outcome(), Goal::Outcome::kStopped);
  EXPECT_EQ(goal.message(), "emergency stop");
}

TEST(SequenceMonitor, TellsLossRepetitionAndReordering) {
  SequenceMonitor monitor;
  EXPECT_EQ(monitor.take(1), Verdict::kNext);
  EXPECT_EQ(monitor.take(2), Verdict::kNext);
  EXPECT_EQ(monitor.take(2), Verdict::kRepeated);
  EXPECT_EQ(monitor.take(5), Verdict::kNext);
  EXPECT_EQ(monitor.counts().lost, 2u);
  EXPECT_EQ(monitor.take(4), Verdict::kLate);
  EXPECT_EQ(monitor.take(4), Verdict::kRepeated);
  EXPECT_EQ(monitor.counts().lost, 1u);
  EXPECT_EQ(monitor.counts().repeated, 2u);
  EXPECT_EQ(monitor.counts().reordered, 1u);
  EXPECT_EQ(monitor.counts().received, 6u);
}

TEST(SequenceMonitor, StartsAnewWithAStream) {
  SequenceMonitor monitor;
  monitor.take(100);
  monitor.restart();
  EXPECT_EQ(monitor.take(1), Verdict::kNext);
  EXPECT_EQ(monitor.take(2000), Verdict::kNext);
  EXPECT_EQ(monitor.counts().lost, 99u + 1998u);
}
