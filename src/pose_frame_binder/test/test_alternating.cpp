// Copyright 2026 the scan cell developers SPDX-License-Identifier: BSD-3-Clause Which laser drew a
// frame's line, above all if they take turns.
#include <gtest/gtest.h>

#include "accounts.h"

using namespace pose_frame_binder;  // NOLINT

namespace {

/// The scan without its first frames.
SyntheticScan without_first_frames(SyntheticScan scan, std::size_t count) {
  const auto lost = static_cast<std::ptrdiff_t>(count);
  scan.frames.erase(scan.frames.begin(), scan.frames.begin() + lost);
  scan.truth.erase(scan.truth.begin(), scan.truth.begin() + lost);
  return scan;
}

std::string detail_of(const Outcome& outcome, std::size_t frame) {
  for (const Drop& drop : outcome.audit.dropped)
    if (drop.frame == frame && drop.reason == DropReason::kLaserUncertain) return drop.detail;
  return "";
}

}  // namespace

TEST(Alternating, HandsOnTheLaserOfEachPulse) {
  const SyntheticScan scan = alternating_scan(100);
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_lit(scan, outcome), 100U);
  EXPECT_EQ(count_right(scan, outcome), 100U);
  EXPECT_TRUE(outcome.audit.dropped.empty());
}

TEST(Alternating, IsTheSameWhateverOrderTheTopicsComeIn) {
  SyntheticScan scan = without_first_frames(alternating_scan(300, 2.06), 2);
  scan.frames[100].corrupt = "broken";
  scan.frames[200].stamp += kMillisecond;
  const Outcome expected = run(scan, {}, 0, {1000, 1, 0.001});
  EXPECT_GT(expected.audit.frames_bound, 280U);
  for (const std::array<double, 3>& weights : std::vector<std::array<double, 3>>{
           {0.001, 1, 1000}, {1, 0.01, 1}, {5, 1, 1}, {0.01, 1, 1}}) {
    const Outcome other = run(scan, {}, 7, weights);
    EXPECT_EQ(count_lit(scan, other), expected.audit.frames_bound);
    ASSERT_EQ(other.audit.dropped.size(), expected.audit.dropped.size());
    for (std::size_t i = 0; i < other.audit.dropped.size(); ++i) {
      EXPECT_EQ(other.audit.dropped[i].frame, expected.audit.dropped[i].frame);
      EXPECT_EQ(other.audit.dropped[i].detail, expected.audit.dropped[i].detail);
    }
  }
}

TEST(Alternating, DropsAndCountsFramesWhoseLaserIsNotCertain) {
  SyntheticScan scan = steady_scan(20);  // laser_0
  scan.pulses[5].lasers = 0;
  scan.pulses[6].lasers = 3;
  scan.frames[8].laser = 1;
  scan.frames[9].laser = 7;
  scan.frames[10].laser = 0;
  scan.pulses[11].lasers = 3;
  scan.frames[11].laser = 1;
  scan.pulses[12].lasers = 0;
  scan.frames[12].laser = 0;
  // These masks differ, so the latency must be proved: by pulses that were left out.
  for (std::size_t i : {2, 4}) {
    for (std::size_t k = i; k < scan.pulses.size(); ++k) {
      scan.pulses[k].time += 10 * kMillisecond;
      scan.frames[k].stamp += 10 * kMillisecond;
    }
  }
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(detail_of(outcome, 5), "no laser was on with its pulse");
  EXPECT_EQ(detail_of(outcome, 6), "laser_0 and laser_1 were on with its pulse");
  EXPECT_EQ(detail_of(outcome, 8),
            "the camera says laser_1, but laser_0 alone was on with its pulse");
  EXPECT_EQ(detail_of(outcome, 9),
            "the camera says laser_7, but laser_0 alone was on with its pulse");
  EXPECT_EQ(detail_of(outcome, 12), "the camera says laser_0, but no laser was on with its pulse");
  EXPECT_EQ(outcome.audit.frames_laser_uncertain, 5U);
  EXPECT_EQ(outcome.dropped(DropReason::kLaserUncertain), 5U);
  EXPECT_STREQ(name(DropReason::kLaserUncertain), "laser_uncertain");
  EXPECT_EQ(outcome.audit.frames_bound, 15U);
  EXPECT_EQ(outcome.match(10)->laser, 0);
  EXPECT_EQ(outcome.match(11)->laser, 1) << "both were on, and the camera tells them apart";
  expect_all_accounted(scan, outcome);
}

class AlternatingLatency : public testing::TestWithParam<double> {};

TEST_P(AlternatingLatency, NeverTakesTheOtherLaserWhereItIsWrongByIntervals) {
  const double period = GetParam();  // [ms]
  constexpr double kTrue = 4;        // [ms]
  for (double intervals = -6; intervals <= 6; intervals += 0.25) {
    for (std::size_t lost = 0; lost < 8; ++lost) {
      const SyntheticScan scan = without_first_frames(alternating_scan(200, period), lost);
      Settings settings;
      settings.camera_latency = (kTrue + intervals * period) / 1000;
      if (settings.camera_latency < -0.1) continue;
      const Outcome outcome = run(scan, settings);
      SCOPED_TRACE(testing::Message() << intervals << " intervals, " << lost << " lost");
      EXPECT_EQ(count_lit(scan, outcome), count_right(scan, outcome));
      expect_all_accounted(scan, outcome);
      if (std::abs(intervals) < 0.3 && lost < 4) {
        EXPECT_EQ(outcome.audit.frames_bound, 200 - lost);
      }
      if (std::abs(intervals) == 1) {
        EXPECT_EQ(outcome.audit.frames_bound, 0U);
        EXPECT_GT(outcome.audit.frames_laser_uncertain, 150U);
        if (lost == 0) {
          EXPECT_TRUE(outcome.audit.latency_doubtful);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Periods, AlternatingLatency, testing::Values(2.062, 10.0, 50.0));

TEST(Alternating, DropsWhatNoIrregularIntervalProves) {
  const SyntheticScan scan = alternating_scan(200, 10, 0);
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(outcome.audit.frames_bound, 0U);
  EXPECT_EQ(outcome.dropped(DropReason::kLaserUncertain), 200U);
  EXPECT_NE(detail_of(outcome, 100).find("it may belong to the pulse before or after"),
            std::string::npos);
  expect_all_accounted(scan, outcome);
}

TEST(Alternating, IsProvedByPulsesThatWereLeftOutLater) {
  SyntheticScan scan = alternating_scan(200, 10, 0);
  for (const std::size_t left_out : {100, 120}) {
    for (std::size_t i = left_out; i < scan.pulses.size(); ++i) {
      scan.pulses[i].time += 10 * kMillisecond;
      scan.frames[i].stamp += 10 * kMillisecond;
    }
  }
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_lit(scan, outcome), count_right(scan, outcome));
  EXPECT_GE(outcome.audit.frames_bound, 140U) << "those that waited, and those that followed";
  EXPECT_LT(outcome.audit.frames_bound, 150U) << "64 wait, the others before them were dropped";
}

TEST(Alternating, NeedsNoProofWhereTheLaserStaysTheSame) {
  const SyntheticScan scan = steady_scan(50);
  Settings settings;
  EXPECT_EQ(run(scan, settings).audit.frames_bound, 50U);
  settings.camera_latency = 14e-3;  // wrong by an interval: so are its poses, but not the laser
  EXPECT_GT(run(scan, settings).audit.frames_bound, 40U);
}

namespace {

/// The camera is restarted at the frame with index 50.
SyntheticScan started_again() {
  SyntheticScan scan = alternating_scan(100);
  for (std::size_t i = 50; i < 100; ++i) {
    scan.frames[i].acquisition = 2;
    scan.frames[i].counter = i - 50;
  }
  return scan;
}

}  // namespace

TEST(Alternating, ProvesTheLatencyAnewAfterTheCameraWasStartedAgain) {
  const SyntheticScan scan = started_again();
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_lit(scan, outcome), 48U);
  EXPECT_EQ(outcome.dropped(DropReason::kLaserUncertain), 48U);
  expect_all_accounted(scan, outcome);
}

TEST(Alternating, IsProvedForWhatWaitsByTheNextArming) {
  SyntheticScan scan = started_again();
  constexpr double kNext = 3003;  // [ms] of the next arming
  for (std::size_t i = 0; i < 100; ++i) {
    scan.add_pulse(kNext + 10.0 * static_cast<double>(i + std::min<std::size_t>(i, 4)), 2);
    scan.pulses.back().lasers = i % 2 == 0 ? 1 : 2;
    scan.add_frame(scan.pulses.size() - 1, 50 + i, 4, 2);
  }
  for (double t = 1501; t < 5000; t += 2)
    scan.poses.push_back(pose_at(t, t / 1000));
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_lit(scan, outcome), count_right(scan, outcome));
  EXPECT_EQ(outcome.audit.frames_bound, 48U + 48U + 100U);
}

TEST(Alternating, StaysProvedWhereTheCounterSlips) {
  SyntheticScan scan = alternating_scan(100);
  scan.frames.erase(scan.frames.begin() + 50);  // the camera did not take the pulse, and counts on
  scan.truth.erase(scan.truth.begin() + 50);
  for (std::size_t i = 50; i < scan.frames.size(); ++i)
    --scan.frames[i].counter;
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_lit(scan, outcome), 95U);
  EXPECT_EQ(count_right(scan, outcome), 95U);
  EXPECT_EQ(outcome.audit.slips, 1U);
}
