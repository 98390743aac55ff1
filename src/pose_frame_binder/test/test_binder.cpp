// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "accounts.h"
#include "scan_cell_common/errors/errors.h"

using namespace pose_frame_binder;  // NOLINT

TEST(Binder, BindsEveryFrameOfAWholeScan) {
  const SyntheticScan scan = steady_scan(100);
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 100U);
  EXPECT_TRUE(outcome.audit.dropped.empty());
  EXPECT_EQ(outcome.audit.by_rule[static_cast<int>(Rule::kInterpolated)], 100U);
  EXPECT_NEAR(outcome.audit.latency, 4e-3, 1e-6);
}

TEST(Binder, BindsAScanOfOneFrame) {
  const SyntheticScan scan = steady_scan(1);
  EXPECT_EQ(count_right(scan, run(scan, {})), 1U);
}

TEST(Binder, StandsJitterAndADriftingLatency) {
  SyntheticScan scan;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> pulse_jitter(-1, 1);
  std::exponential_distribution<double> late(2.0);  // mean 0.5 ms, never early
  for (std::size_t i = 0; i < 2000; ++i) {
    scan.add_pulse(static_cast<double>(i) * 10 + pulse_jitter(random));
    scan.add_frame(i, i, 3 + 0.004 * static_cast<double>(i) + std::min(late(random), 2.5));
  }
  for (double t = -50; t < 20100; t += 4)
    scan.poses.push_back(pose_at(t, t / 1000));
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 2000U);
}

TEST(Binder, TakesOutADelayOfThePoses) {
  const SyntheticScan scan = steady_scan(50);  // the flange is at x = 1 m/s x time
  Settings settings;
  settings.pose_delay = 0.013;
  const Outcome outcome = run(scan, settings);
  ASSERT_EQ(outcome.audit.frames_bound, 50U);
  EXPECT_NEAR(outcome.match(0)->pose.translation().x(), 0.013, 1e-9);
  EXPECT_NEAR(outcome.match(20)->pose.translation().x(), 0.213, 1e-9);
}

TEST(Binder, GivesTheSameWhateverOrderTheTopicsComeIn) {
  SyntheticScan scan = steady_scan(300);
  scan.frames.erase(scan.frames.begin() + 100, scan.frames.begin() + 103);
  scan.frames[200].corrupt = "broken";
  std::swap(scan.frames[50], scan.frames[51]);
  for (std::size_t i = 5; i + 1 < scan.poses.size(); i += 7)
    std::swap(scan.poses[i], scan.poses[i + 1]);
  for (const Method method : {Method::kInterpolate, Method::kFirstPose}) {
    Settings settings;
    settings.method = method;
    const Outcome expected = run(scan, settings, 0, {1000, 1, 0.001});
    EXPECT_GT(expected.audit.frames_bound, 250U);
    for (const std::array<double, 3>& weights : std::vector<std::array<double, 3>>{
             {0.001, 1, 1000}, {1, 0.01, 1}, {5, 1, 1}, {0.01, 1, 1}}) {
      const Outcome other = run(scan, settings, 7, weights);
      std::vector<const Decision*> a, b;
      for (const Decision& d : expected.decisions)
        if (d.match) a.push_back(&d);
      for (const Decision& d : other.decisions)
        if (d.match) b.push_back(&d);
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i]->frame, b[i]->frame);
        ASSERT_EQ(a[i]->match->pulse.count, b[i]->match->pulse.count);
        ASSERT_EQ(a[i]->match->rule, b[i]->match->rule);
        ASSERT_EQ(a[i]->match->pose.matrix(), b[i]->match->pose.matrix());
        ASSERT_EQ(a[i]->match->position_error_bound, b[i]->match->position_error_bound);
      }
      ASSERT_EQ(expected.audit.dropped.size(), other.audit.dropped.size());
      for (std::size_t i = 0; i < expected.audit.dropped.size(); ++i) {
        EXPECT_EQ(expected.audit.dropped[i].reason, other.audit.dropped[i].reason);
        EXPECT_EQ(expected.audit.dropped[i].frame, other.audit.dropped[i].frame);
        EXPECT_EQ(expected.audit.dropped[i].detail, other.audit.dropped[i].detail);
      }
    }
  }
}

TEST(Binder, SaysWhenTheLatencyItWasToldIsProbablyWrongByAPeriod) {
  const SyntheticScan scan = steady_scan(50);
  Settings settings;
  EXPECT_FALSE(run(scan, settings).audit.latency_doubtful);
  settings.camera_latency = 14e-3;
  EXPECT_TRUE(run(scan, settings).audit.latency_doubtful);
  settings.camera_latency = -6e-3;
  EXPECT_TRUE(run(scan, settings).audit.latency_doubtful);
}

TEST(Binder, CountsThePulsesThatItNeverHeardOfAndThoseItRefused) {
  const SyntheticScan scan = steady_scan(20);
  Binder binder({});
  for (const Pulse& pulse : scan.pulses) {
    binder.add_pulse(pulse);
    if (pulse.count % 10 == 0) binder.add_pulse(pulse);
  }
  binder.end(23);
  EXPECT_EQ(binder.audit().triggers, 23U);
  EXPECT_EQ(binder.audit().triggers_missing, 3U);
  EXPECT_EQ(binder.audit().triggers_refused, 2U);
}

TEST(Binder, RefusesSettingsThatMakeNoSenseByName) {
  const auto refused = [](const std::function<void(Settings&)>& change) -> std::string {
    Settings settings;
    change(settings);
    try {
      const Binder binder(settings);
    } catch (const scan_cell_common::InvalidParameter& error) {
      return error.thing();
    }
    return "nothing";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refused([](Settings&) {}), "nothing");
  EXPECT_EQ(refused([&](Settings& s) { s.camera_latency = nan; }), "camera_latency");
  EXPECT_EQ(refused([&](Settings& s) { s.camera_latency = infinite; }), "camera_latency");
  EXPECT_EQ(refused([](Settings& s) { s.max_pose_gap = -0.05; }), "max_pose_gap");
  EXPECT_EQ(refused([](Settings& s) { s.pose_settle = -1; }), "pose_settle");
  EXPECT_EQ(refused([](Settings& s) { s.latency_tolerance = 0; }), "latency_tolerance");
  EXPECT_EQ(refused([](Settings& s) { s.frames_to_agree = 1; }), "frames_to_agree");
  EXPECT_EQ(refused([&](Settings& s) { s.max_acceleration = nan; }), "max_acceleration");
  EXPECT_EQ(refused([&](Settings& s) { s.max_speed = nan; }), "max_speed");
}

TEST(Binder, PublishesWhileTheScanRuns) {
  const SyntheticScan scan = steady_scan(50);
  Binder binder({});
  std::size_t pose = 0;
  std::size_t bound = 0;
  for (std::size_t i = 0; i < 50; ++i) {
    binder.add_pulse(scan.pulses[i]);
    while (scan.poses[pose].time < scan.frames[i].stamp)
      binder.add_pose(scan.poses[pose++]);
    binder.add_frame(scan.frames[i]);
    bound += binder.take_decisions().size();
    if (i > 10) {
      EXPECT_GE(bound + 5, i);
    }
  }
}

TEST(Binder, KnowsWhenAScanIsWhole) {
  const SyntheticScan scan = steady_scan(20);
  Binder binder({});
  for (const TimedPose& pose : scan.poses)
    binder.add_pose(pose);
  for (const Pulse& pulse : scan.pulses)
    binder.add_pulse(pulse);
  for (std::size_t i = 0; i < 19; ++i)
    binder.add_frame(scan.frames[i]);
  binder.end_pulses();
  EXPECT_FALSE(binder.whole(20));
  binder.add_frame(scan.frames[19]);
  EXPECT_TRUE(binder.whole(20));
  EXPECT_FALSE(binder.whole(21));
}

TEST(Binder, RefusesMoreFramesThanItMayHold) {
  Settings settings;
  settings.max_pending_frames = 10;
  Binder binder(settings);
  const SyntheticScan scan = steady_scan(20);
  for (std::size_t i = 0; i < 10; ++i)
    binder.add_frame(scan.frames[i]);
  EXPECT_THROW(binder.add_frame(scan.frames[10]), scan_cell_common::Refused);
}
