// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "accounts.h"

using namespace pose_frame_binder;  // NOLINT

namespace {

SyntheticScan armed_twice_with_poses() {
  SyntheticScan scan = armed_twice();
  for (double t = 401; t < 1500; t += 2)
    scan.poses.push_back(pose_at(t, t / 1000));
  return scan;
}

}  // namespace

TEST(Binder, IsRightWhereTheFirstFramesWereLost) {
  SyntheticScan scan = steady_scan(50);
  scan.frames.erase(scan.frames.begin(), scan.frames.begin() + 7);
  scan.truth.erase(scan.truth.begin(), scan.truth.begin() + 7);
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 43U);
  EXPECT_EQ(outcome.audit.frames_never_arrived, 7U);
  expect_all_accounted(scan, outcome);
}

TEST(Binder, LeavesAGapWhereFramesWereLost) {
  SyntheticScan scan = steady_scan(50);
  scan.frames.erase(scan.frames.begin() + 20, scan.frames.begin() + 22);
  scan.truth.erase(scan.truth.begin() + 20, scan.truth.begin() + 22);
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 48U);
  EXPECT_EQ(outcome.dropped(DropReason::kNeverArrived), 2U);
  EXPECT_EQ(outcome.audit.dropped[0].trigger_count, 21U);
}

TEST(Binder, DropsFramesFromBeforeTheArming) {
  SyntheticScan scan = steady_scan(50);
  for (int i = 5; i > 0; --i) {
    const std::uint64_t counter = 101 - static_cast<std::uint64_t>(i);
    scan.frames.insert(scan.frames.begin() + (5 - i), {1, counter, at(-1000 - 10.0 * i), ""});
    scan.truth.insert(scan.truth.begin(), -1);
  }
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 50U);
  EXPECT_EQ(outcome.dropped(DropReason::kNoTrigger), 5U);
}

TEST(Binder, DropsRepeatedLateAndCorruptFramesByTheirReason) {
  SyntheticScan scan = steady_scan(50);
  scan.frames.insert(scan.frames.begin() + 11, scan.frames[10]);
  scan.truth.insert(scan.truth.begin() + 11, scan.truth[10]);
  std::swap(scan.frames[20], scan.frames[21]);
  std::swap(scan.truth[20], scan.truth[21]);
  scan.frames[30].corrupt = "3 packets missing";
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 48U);
  EXPECT_EQ(outcome.dropped(DropReason::kRepeated), 1U);
  EXPECT_EQ(outcome.dropped(DropReason::kOutOfOrder), 1U);
  EXPECT_EQ(outcome.dropped(DropReason::kCorrupt), 1U);
  EXPECT_EQ(outcome.audit.frames_never_arrived, 0U);
  expect_all_accounted(scan, outcome);
}

TEST(Binder, FindsASlipOfOneThatTheCounterHides) {
  // The camera does not take the pulse with index 25, and continues counting without a gap.
  SyntheticScan scan = steady_scan(50);
  scan.frames.erase(scan.frames.begin() + 25);
  scan.truth.erase(scan.truth.begin() + 25);
  for (std::size_t i = 25; i < scan.frames.size(); ++i)
    --scan.frames[i].counter;
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(outcome.audit.slips, 1U);
  EXPECT_EQ(outcome.dropped(DropReason::kCounterSlip), 4U);  // two on either side
  EXPECT_EQ(outcome.dropped(DropReason::kNeverArrived), 1U);
  EXPECT_EQ(count_right(scan, outcome), 45U);
  expect_all_accounted(scan, outcome);
}

TEST(Binder, DropsAFrameWhoseCounterOrStampIsWrong) {
  SyntheticScan scan = steady_scan(50);
  ++scan.frames[12].counter;                   // the next frame has the same one
  scan.frames[31].stamp += 10 * kMillisecond;  // a whole period
  scan.frames[40].counter += 1'000'000;
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 47U);
  EXPECT_EQ(outcome.dropped(DropReason::kCounterSlip), 3U);
  EXPECT_EQ(outcome.audit.slips, 0U);
}

TEST(Binder, GoesOnAfterTheCameraWasRestarted) {
  SyntheticScan scan = steady_scan(60);
  for (std::size_t i = 30; i < 60; ++i) {
    scan.frames[i].acquisition = 2;
    scan.frames[i].counter = i - 30;
  }
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 56U);
  EXPECT_EQ(outcome.dropped(DropReason::kCounterSlip), 4U);  // two on either side
  expect_all_accounted(scan, outcome);
}

namespace {

/// A frame that no pulse exposed, 0.4 ms after the one with this index; the camera counts it.
void invent_frame(SyntheticScan& scan, std::size_t after) {
  Frame invented = scan.frames[after];
  invented.stamp += 2 * kMillisecond / 5;
  for (std::size_t i = after + 1; i < scan.frames.size(); ++i)
    ++scan.frames[i].counter;
  ++invented.counter;
  const auto place = static_cast<std::ptrdiff_t>(after + 1);
  scan.frames.insert(scan.frames.begin() + place, invented);
  scan.truth.insert(scan.truth.begin() + place, -1);
}

void lose_frame(SyntheticScan& scan, std::size_t frame) {
  scan.frames.erase(scan.frames.begin() + static_cast<std::ptrdiff_t>(frame));
  scan.truth.erase(scan.truth.begin() + static_cast<std::ptrdiff_t>(frame));
}

}  // namespace

TEST(Binder, NeverBindsAFrameThatNoPulseExposed) {
  for (std::size_t place = 0; place < 30; ++place) {
    for (const bool own_lost : {false, true}) {
      SyntheticScan scan = steady_scan(60);
      invent_frame(scan, 20 + place);
      if (own_lost) lose_frame(scan, 20 + place);
      // The frame after it has a stamp that would confirm the old offset, others are wrong too.
      scan.frames[22 + place].stamp += 10 * kMillisecond;
      scan.frames[17].counter += 1;
      const Outcome outcome = run(scan, {});
      EXPECT_GE(count_right(scan, outcome), 50U);
      expect_all_accounted(scan, outcome);
    }
  }
}

TEST(Binder, NeverBindsAnInventedFrameNextToARestart) {
  for (std::size_t restart = 21; restart < 30; ++restart) {
    SyntheticScan scan = steady_scan(60);
    invent_frame(scan, 24);
    lose_frame(scan, 24);  // the pulse's own
    for (std::size_t i = restart; i < scan.frames.size(); ++i)
      scan.frames[i].acquisition = 2;
    const Outcome outcome = run(scan, {});
    EXPECT_GE(count_right(scan, outcome), 50U) << restart;
    expect_all_accounted(scan, outcome);
  }
}

TEST(Binder, NeverBindsAnInventedFrameAtTheEndOfAnArming) {
  SyntheticScan scan = armed_twice_with_poses();
  invent_frame(scan, 28);
  lose_frame(scan, 30);  // of the arming's last pulse, which the invented one could be
  scan.frames[29].stamp += 9 * kMillisecond;
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 56U);  // but two on either side
}

TEST(Binder, GoesOnAfterTheTriggerWasArmedAgain) {
  const SyntheticScan scan = armed_twice_with_poses();
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 60U);
  EXPECT_EQ(outcome.audit.slips, 0U);
}

TEST(Binder, DropsAndCountsFramesWhoseCounterJumpsBack) {
  SyntheticScan scan = steady_scan(50);
  for (std::size_t i = 30; i < 50; ++i)
    scan.frames[i].counter -= 25;  // the camera was restarted without a report
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 30U);
  EXPECT_EQ(outcome.dropped(DropReason::kRepeated), 20U);
  expect_all_accounted(scan, outcome);
}

TEST(Binder, DropsWhatLostPosesLeaveWithoutOne) {
  SyntheticScan scan = steady_scan(60);
  const auto lost = [](const TimedPose& pose) {
    return pose.time > at(205) && pose.time < at(285);
  };
  scan.poses.erase(std::remove_if(scan.poses.begin(), scan.poses.end(), lost), scan.poses.end());
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(outcome.dropped(DropReason::kPoseGap), 8U);  // pulses at 210, 220 ... 280 ms
  EXPECT_EQ(count_right(scan, outcome), 52U);
  expect_all_accounted(scan, outcome);
}
