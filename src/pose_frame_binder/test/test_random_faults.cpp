// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// A long scan in which one frame in five has a fault.
#include <gtest/gtest.h>

#include "accounts.h"

using namespace pose_frame_binder;  // NOLINT

namespace {

constexpr std::size_t kFrames = 100'000;

class FaultyScan {
 public:
  FaultyScan(unsigned seed, bool alternate) : alternate_(alternate), random_(seed) { make(); }
  SyntheticScan scan;
  std::size_t faults = 0;

 private:
  bool chance(double probability) {
    const bool hit = std::bernoulli_distribution(probability)(random_);
    faults += hit;
    return hit;
  }
  double uniform(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }

  void make() {
    double time = 0;
    for (std::size_t i = 0; i < kFrames; ++i) {
      const bool slow = alternate_ && i >= 1 && i <= 4;
      time += chance(0.002) || slow ? 20 : 10;  // a missed deadline of the trigger
      scan.add_pulse(time + uniform(-0.5, 0.5));
      if (alternate_) scan.pulses.back().lasers = i % 2 == 0 ? 1 : 2;
    }
    std::uint64_t counter = 65400;
    std::uint32_t acquisition = 1;
    for (std::size_t i = 0; i < kFrames; ++i) {
      if (chance(0.0005)) {  // the camera was restarted
        ++acquisition;
        counter = static_cast<std::uint64_t>(uniform(0, 3));
      }
      if (chance(0.003)) continue;  // the camera did not take the pulse: the counter slips
      ++counter;
      if (chance(0.05)) continue;  // lost
      scan.add_frame(i, counter, 4 + uniform(0, 1.5), acquisition);
      Frame& frame = scan.frames.back();
      if (chance(0.05)) frame.corrupt = "packets missing";
      if (chance(0.01)) {  // only one is wrong: both wrong together cannot be detected
        frame.counter += static_cast<std::uint64_t>(uniform(1, 100));
      } else if (chance(0.01)) {
        frame.stamp += static_cast<Nanoseconds>(uniform(-50, 50)) * kMillisecond;
      }
      if (chance(0.04)) {  // repeated
        scan.frames.push_back(scan.frames.back());
        scan.truth.push_back(scan.truth.back());
      }
    }
    for (std::size_t i = 3; i < scan.frames.size(); ++i) {
      if (!chance(0.02)) continue;  // late
      const std::size_t back = i - 1 - static_cast<std::size_t>(uniform(0, 2));
      std::swap(scan.frames[i], scan.frames[back]);
      std::swap(scan.truth[i], scan.truth[back]);
    }
    for (double t = -20; t < time + 100; t += 4 + uniform(0, 1)) {
      if (chance(0.02)) continue;
      if (chance(0.0002)) t += 80;
      scan.poses.push_back(pose_at(t, t / 1000));
      if (chance(0.02) && scan.poses.size() > 2)
        std::swap(scan.poses.back(), *(scan.poses.end() - 2));
    }
  }

  const bool alternate_;
  std::mt19937 random_;
};

}  // namespace

class RandomFaults : public testing::TestWithParam<unsigned> {};

TEST_P(RandomFaults, NeverPairAFrameWithAnotherPulseAndAreAllAccountedFor) {
  const FaultyScan faulty(GetParam(), false);
  const SyntheticScan& scan = faulty.scan;
  EXPECT_GT(faulty.faults, kFrames / 5);
  const Outcome outcome = run(scan, {}, GetParam(), {3, 1, 1});
  std::size_t wrong = 0;
  std::vector<char> fate(scan.pulses.size(), 0);
  for (const Decision& decision : outcome.decisions) {
    if (!decision.match) continue;
    const std::size_t pulse = decision.match->pulse.count - 1;
    wrong += scan.truth[decision.frame] != static_cast<std::int64_t>(pulse);
    // The x of a pose says when it was measured.
    const double milliseconds = decision.match->pose.translation().x() * 1000;
    wrong += std::abs(static_cast<double>(at(milliseconds) - scan.pulses[pulse].time)) > 1000;
    EXPECT_EQ(fate[pulse], 0);
    fate[pulse] = 1;
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(outcome.decisions.size(), scan.frames.size());
  EXPECT_EQ(outcome.audit.frames, outcome.audit.frames_bound + outcome.audit.frames_dropped);
  for (const Drop& drop : outcome.audit.dropped) {
    if (drop.trigger_count == 0) continue;
    char& pulse = fate[drop.trigger_count - 1];
    if (drop.reason == DropReason::kNeverArrived) {
      EXPECT_EQ(pulse, 0);
    }
    pulse = 1;
  }
  EXPECT_EQ(std::count(fate.begin(), fate.end(), 0), 0);
  EXPECT_GT(outcome.audit.frames_bound, kFrames * 3 / 4);
  RecordProperty("frames", static_cast<int>(outcome.audit.frames));
  RecordProperty("bound", static_cast<int>(outcome.audit.frames_bound));
}

TEST_P(RandomFaults, NeverGiveAFrameTheLaserOfAnotherPulse) {
  const FaultyScan faulty(GetParam(), true);
  const Outcome outcome = run(faulty.scan, {}, GetParam(), {3, 1, 1});
  const std::size_t lit = count_lit(faulty.scan, outcome);
  EXPECT_EQ(lit, outcome.audit.frames_bound);
  EXPECT_EQ(count_right(faulty.scan, outcome), lit);
  expect_all_accounted(faulty.scan, outcome);
  // After each of the camera's 50 starts the latency is proved again, by missed deadlines.
  EXPECT_GT(lit, kFrames / 4);
  EXPECT_GT(outcome.dropped(DropReason::kLaserUncertain), 0U);
  EXPECT_EQ(outcome.audit.frames_laser_uncertain, outcome.dropped(DropReason::kLaserUncertain));
  RecordProperty("bound", static_cast<int>(lit));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFaults, testing::Values(1U, 2U, 3U));
