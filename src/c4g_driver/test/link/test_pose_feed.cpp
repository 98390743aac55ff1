// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "link/pose_feed.h"

using c4g_driver::MotionStatus;
using c4g_driver::PoseFeed;
using scan_cell_common::Nanoseconds;
using Source = PoseFeed::Source;
using PoseVerdict = PoseFeed::Verdict;

namespace {

constexpr Nanoseconds kMillisecond = 1'000'000;
constexpr Nanoseconds kBoot = 1'700'000'000'000 * kMillisecond;  // host time as the test begins
constexpr Nanoseconds kDelay = kMillisecond / 10;                // of the wire

/// A controller whose states arrive at times of its own clock.
class PoseFeedTest : public testing::Test {
 protected:
  static PoseFeed::Clock::time_point steady(Nanoseconds time) {
    return PoseFeed::Clock::time_point(std::chrono::nanoseconds(time));
  }

  PoseVerdict hear(Nanoseconds time, Source source = Source::kStream,
                   MotionStatus status = MotionStatus::kMoving) {
    c4g_driver::RobotState robot;
    robot.controller_time = time;
    robot.status = status;
    return feed_.take(robot, kBoot + host_is_ahead_ + time + kDelay, source, steady(time));
  }

  /// @return when it became stale, or `end`
  Nanoseconds stale_from(Nanoseconds begin, Nanoseconds end, Nanoseconds period, Source source,
                         MotionStatus status) {
    for (Nanoseconds time = begin; time < end; time += period) {
      hear(time, source, status);
      if (feed_.stale(steady(time))) return time;
    }
    return end;
  }

  void SetUp() override { feed_.restart(steady(0)); }

  PoseFeed feed_{2.0, 0.5};
  Nanoseconds host_is_ahead_ = 0;
};

constexpr Nanoseconds kSecond = 1000 * kMillisecond;
constexpr Nanoseconds kStreamPeriod = 4 * kMillisecond;
constexpr Nanoseconds kPollPeriod = 100 * kMillisecond;
constexpr Nanoseconds kTimeout = kSecond / 2;

}  // namespace

TEST_F(PoseFeedTest, HandsOnEachPoseWithItsInstantOnce) {
  EXPECT_EQ(hear(kSecond), PoseVerdict::kHandOn);
  EXPECT_EQ(feed_.latest()->time, kBoot + kSecond + kDelay);
  EXPECT_EQ(hear(kSecond), PoseVerdict::kOvertaken);
  EXPECT_EQ(hear(kSecond / 2), PoseVerdict::kOvertaken);
  EXPECT_EQ(feed_.dropped().overtaken, 2u);
  EXPECT_EQ(hear(kSecond + kStreamPeriod), PoseVerdict::kHandOn);
}

TEST_F(PoseFeedTest, StaysFreshWithTheStreamOfAMotionAndThePollsOfARest) {
  EXPECT_EQ(stale_from(1, 10 * kSecond, kPollPeriod, Source::kAcknowledgement, MotionStatus::kIdle),
            10 * kSecond);
  EXPECT_EQ(stale_from(10 * kSecond + 1, 20 * kSecond, kStreamPeriod, Source::kStream,
                       MotionStatus::kMoving),
            20 * kSecond);
  EXPECT_EQ(stale_from(20 * kSecond + 1, 30 * kSecond, kPollPeriod, Source::kAcknowledgement,
                       MotionStatus::kArrived),
            30 * kSecond);
}

TEST_F(PoseFeedTest, IsStaleWithoutPoses) {
  hear(kSecond);
  EXPECT_FALSE(feed_.stale(steady(kSecond + kTimeout)));
  EXPECT_TRUE(feed_.stale(steady(kSecond + kTimeout + 1)));
}

TEST_F(PoseFeedTest, IsStaleInAMotionWhoseStreamStoppedThoughRequestsAreAnswered) {
  hear(kSecond);
  const Nanoseconds from = stale_from(kSecond + 1, 10 * kSecond, kPollPeriod,
                                      Source::kAcknowledgement, MotionStatus::kMoving);
  EXPECT_GT(from, kSecond + kTimeout);
  EXPECT_LE(from, kSecond + kTimeout + kPollPeriod + 1);
}

TEST_F(PoseFeedTest, IsStaleAfterTheHostsClockWasSetAndWellAgainAfterARestart) {
  for (const Nanoseconds step : {-30 * kSecond, 30 * kSecond}) {
    const Nanoseconds begin = feed_.latest() ? 20 * kSecond : 0;
    ASSERT_EQ(stale_from(begin + 1, begin + kSecond, kStreamPeriod, Source::kStream,
                         MotionStatus::kMoving),
              begin + kSecond);
    host_is_ahead_ += step;
    const Nanoseconds from = stale_from(begin + kSecond + 1, begin + 10 * kSecond, kStreamPeriod,
                                        Source::kStream, MotionStatus::kMoving);
    EXPECT_LT(from, begin + kSecond + kTimeout + 2 * kStreamPeriod) << step;
    feed_.restart(steady(from));
    EXPECT_EQ(hear(from + kStreamPeriod), PoseVerdict::kHandOn);
    EXPECT_EQ(feed_.latest()->time, kBoot + host_is_ahead_ + from + kStreamPeriod + kDelay);
    EXPECT_FALSE(feed_.stale(steady(from + kTimeout)));
  }
  EXPECT_GT(feed_.dropped().backward, 100u);
}

TEST_F(PoseFeedTest, IsStaleWhenThePosesThatComeAreOld) {
  hear(kSecond);
  c4g_driver::RobotState robot;
  robot.status = MotionStatus::kMoving;
  Nanoseconds waited = 0;
  while (waited < 3 * kSecond && !feed_.stale(steady(kSecond + waited))) {
    waited += kStreamPeriod;
    robot.controller_time = kSecond + waited / 4;  // delayed in transit, longer and longer
    const Nanoseconds now = kSecond + waited;
    EXPECT_EQ(feed_.take(robot, kBoot + now + kDelay, Source::kStream, steady(now)),
              PoseVerdict::kHandOn);
  }
  // three quarters of the waiting reach the timeout, then the timeout itself runs
  EXPECT_NEAR(static_cast<double>(waited), kTimeout / 0.75 + kTimeout, 3 * kStreamPeriod);
}

TEST_F(PoseFeedTest, CountsAPoseThatABetterEstimateOfTheDelayPutsBeforeTheLast) {
  hear(kSecond);
  c4g_driver::RobotState robot;
  robot.controller_time = kSecond + kDelay / 4;
  EXPECT_EQ(feed_.take(robot, kBoot + kSecond + kDelay / 2, Source::kStream, steady(kSecond)),
            PoseVerdict::kBackward);
  EXPECT_EQ(feed_.dropped().backward, 1u);
}
