// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>

#include "pose_frame_binder/binder.h"
#include "scan_cell_common/errors.h"
#include "synthetic_scan.h"

using namespace pose_frame_binder;  // NOLINT

namespace {

/// No frame has another pulse than the one that exposed it; returns how many have one.
std::size_t count_right(const SyntheticScan& scan, const Outcome& outcome) {
  std::size_t right = 0;
  for (const Decision& decision : outcome.decisions) {
    if (!decision.match) continue;
    const std::int64_t truth = scan.truth[decision.frame];
    EXPECT_GE(truth, 0) << "frame " << decision.frame << " has no pulse";
    if (truth < 0) continue;
    EXPECT_EQ(decision.match->pulse.time, scan.pulses[static_cast<std::size_t>(truth)].time)
        << "frame " << decision.frame;
    ++right;
  }
  return right;
}

/// Every frame is decided once, and every pulse is bound, or named by a drop, or never arrived.
void expect_all_accounted(const SyntheticScan& scan, const Outcome& outcome) {
  const Audit& audit = outcome.audit;
  EXPECT_EQ(audit.frames, scan.frames.size());
  EXPECT_EQ(audit.frames, audit.frames_bound + audit.frames_dropped);
  EXPECT_EQ(audit.triggers, scan.pulses.size());
  std::set<std::size_t> decided;
  for (const Decision& decision : outcome.decisions)
    EXPECT_TRUE(decided.insert(decision.frame).second);
  EXPECT_EQ(decided.size(), scan.frames.size());

  std::set<std::uint64_t> bound, dropped;
  for (const Decision& decision : outcome.decisions)
    if (decision.match) {
      EXPECT_TRUE(bound.insert(decision.match->pulse.count).second);
    }
  std::uint64_t never = 0;
  for (const Drop& drop : audit.dropped) {
    if (drop.reason == DropReason::NeverArrived) {
      ++never;
      EXPECT_EQ(bound.count(drop.trigger_count) + dropped.count(drop.trigger_count), 0U);
    } else if (drop.trigger_count > 0 && bound.count(drop.trigger_count) == 0) {
      dropped.insert(drop.trigger_count);
    }
  }
  EXPECT_EQ(never, audit.frames_never_arrived);
  EXPECT_EQ(bound.size() + dropped.size() + never, scan.pulses.size());
}

}  // namespace

TEST(Binder, BindsEveryFrameOfAWholeScan) {
  const SyntheticScan scan = steady_scan(100);
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 100U);
  EXPECT_TRUE(outcome.audit.dropped.empty());
  EXPECT_EQ(outcome.audit.by_rule[static_cast<int>(Rule::Interpolated)], 100U);
  EXPECT_NEAR(outcome.audit.latency, 4e-3, 1e-6);
}

TEST(Binder, BindsAScanOfOneFrame) {
  const SyntheticScan scan = steady_scan(1);
  EXPECT_EQ(count_right(scan, run(scan, {})), 1U);
}

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
  EXPECT_EQ(outcome.dropped(DropReason::NeverArrived), 2U);
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
  EXPECT_EQ(outcome.dropped(DropReason::NoTrigger), 5U);
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
  EXPECT_EQ(outcome.dropped(DropReason::Repeated), 1U);
  EXPECT_EQ(outcome.dropped(DropReason::OutOfOrder), 1U);
  EXPECT_EQ(outcome.dropped(DropReason::Corrupt), 1U);
  EXPECT_EQ(outcome.audit.frames_never_arrived, 0U);
  expect_all_accounted(scan, outcome);
}

TEST(Binder, FindsASlipOfOneThatTheCounterHides) {
  // The camera does not take the pulse with index 25, and counts on without a gap.
  SyntheticScan scan = steady_scan(50);
  scan.frames.erase(scan.frames.begin() + 25);
  scan.truth.erase(scan.truth.begin() + 25);
  for (std::size_t i = 25; i < scan.frames.size(); ++i)
    --scan.frames[i].counter;
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(outcome.audit.slips, 1U);
  EXPECT_EQ(outcome.dropped(DropReason::CounterSlip), 4U);  // two on either side
  EXPECT_EQ(outcome.dropped(DropReason::NeverArrived), 1U);
  EXPECT_EQ(count_right(scan, outcome), 45U);
  expect_all_accounted(scan, outcome);
}

TEST(Binder, DropsAFrameWhoseCounterOrStampIsWrong) {
  SyntheticScan scan = steady_scan(50);
  ++scan.frames[12].counter;                   // the next frame has that one too
  scan.frames[31].stamp += 10 * kMillisecond;  // a whole period
  scan.frames[40].counter += 1'000'000;
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 47U);
  EXPECT_EQ(outcome.dropped(DropReason::CounterSlip), 3U);
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
  EXPECT_EQ(outcome.dropped(DropReason::CounterSlip), 4U);  // two on either side
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
  SyntheticScan scan = steady_scan(30);
  for (int i = 0; i < 30; ++i) {
    scan.add_pulse(1003 + 10.0 * i, 2);
    scan.add_frame(scan.pulses.size() - 1, static_cast<std::uint64_t>(131 + i));
  }
  for (double t = 401; t < 1500; t += 2)
    scan.poses.push_back(pose_at(t, t / 1000));
  invent_frame(scan, 28);
  lose_frame(scan, 30);  // of the arming's last pulse, which the invented one could be
  scan.frames[29].stamp += 9 * kMillisecond;
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 56U);  // but two on either side
}

TEST(Binder, GoesOnAfterTheTriggerWasArmedAgain) {
  SyntheticScan scan = steady_scan(30);
  for (int i = 0; i < 30; ++i) {
    scan.add_pulse(1003 + 10.0 * i, 2);
    scan.add_frame(scan.pulses.size() - 1, static_cast<std::uint64_t>(131 + i));
  }
  for (double t = 401; t < 1500; t += 2)
    scan.poses.push_back(pose_at(t, t / 1000));
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 60U);
  EXPECT_EQ(outcome.audit.slips, 0U);
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

TEST(Binder, DropsAndCountsFramesWhoseCounterJumpsBack) {
  SyntheticScan scan = steady_scan(50);
  for (std::size_t i = 30; i < 50; ++i)
    scan.frames[i].counter -= 25;  // the camera was restarted, and nobody said so
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(count_right(scan, outcome), 30U);
  EXPECT_EQ(outcome.dropped(DropReason::Repeated), 20U);
  expect_all_accounted(scan, outcome);
}

TEST(Binder, DropsWhatLostPosesLeaveWithoutOne) {
  SyntheticScan scan = steady_scan(60);
  const auto lost = [](const TimedPose& pose) {
    return pose.time > at(205) && pose.time < at(285);
  };
  scan.poses.erase(std::remove_if(scan.poses.begin(), scan.poses.end(), lost), scan.poses.end());
  const Outcome outcome = run(scan, {});
  EXPECT_EQ(outcome.dropped(DropReason::PoseGap), 8U);  // pulses at 210, 220 ... 280 ms
  EXPECT_EQ(count_right(scan, outcome), 52U);
  expect_all_accounted(scan, outcome);
}

TEST(Binder, GivesTheSameWhateverOrderTheTopicsComeIn) {
  SyntheticScan scan = steady_scan(300);
  scan.frames.erase(scan.frames.begin() + 100, scan.frames.begin() + 103);
  scan.frames[200].corrupt = "broken";
  std::swap(scan.frames[50], scan.frames[51]);
  for (std::size_t i = 5; i + 1 < scan.poses.size(); i += 7)
    std::swap(scan.poses[i], scan.poses[i + 1]);
  for (const Method method : {Method::Interpolate, Method::FirstPose}) {
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
  EXPECT_EQ(refused([](Settings& s) { s.most_pose_gap = -0.05; }), "most_pose_gap");
  EXPECT_EQ(refused([](Settings& s) { s.pose_settle = -1; }), "pose_settle");
  EXPECT_EQ(refused([](Settings& s) { s.latency_tolerance = 0; }), "latency_tolerance");
  EXPECT_EQ(refused([](Settings& s) { s.frames_to_agree = 1; }), "frames_to_agree");
  EXPECT_EQ(refused([&](Settings& s) { s.most_acceleration = nan; }), "most_acceleration");
  EXPECT_EQ(refused([&](Settings& s) { s.most_speed = nan; }), "most_speed");
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
  settings.most_pending_frames = 5;
  Binder binder(settings);
  const SyntheticScan scan = steady_scan(10);
  for (std::size_t i = 0; i < 5; ++i)
    binder.add_frame(scan.frames[i]);
  EXPECT_THROW(binder.add_frame(scan.frames[5]), scan_cell_common::Refused);
}
