// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The trials of bench_c4g_wire, shortened.
#include <gtest/gtest.h>

#include "follow_trials.h"
#include "robot/smart5_six.h"
#include "wire_trials.h"

using namespace c4g_driver;  // NOLINT

namespace {

std::shared_ptr<const RobotModel> robot() {
  return std::make_shared<const RobotModel>(smart5_six());
}

}  // namespace

TEST(BadWire, HandsOnNoWrongStaleOrRepeatedPose) {
  const StreamTrial trial = run_stream_trial(robot(), 0.002, 3, bad_wire());
  EXPECT_GT(trial.handed_on, 100u);
  EXPECT_GT(trial.link.stream.lost, 0u);
  EXPECT_GT(trial.link.stream.repeated, 0u);
  EXPECT_GT(trial.link.stream.reordered, 0u);
  EXPECT_EQ(trial.wrong, 0u);
  EXPECT_EQ(trial.stale, 0u);
  EXPECT_EQ(trial.repeated, 0u);
  EXPECT_EQ(trial.backward, 0u);
}

TEST(BadWire, HandsOnNoPoseThatWasSpoiltOrHeld) {
  auto faults = bad_wire();
  for (auto* const wire : {&faults.to_client, &faults.from_client}) {
    wire->lost = wire->flipped = wire->truncated = 0.15;
    wire->held = 0.01;
    wire->jitter = 0.005;
  }
  const StreamTrial trial = run_stream_trial(robot(), 0.002, 3, faults);
  EXPECT_GT(trial.handed_on, 100u);
  EXPECT_GT(trial.link.malformed.count, 0u);
  EXPECT_EQ(trial.wrong, 0u);
  EXPECT_EQ(trial.stale, 0u);
  EXPECT_EQ(trial.repeated, 0u);
  EXPECT_EQ(trial.backward, 0u);
}

TEST(BadWire, HasEveryCommandDoneOnceOrRefused) {
  auto faults = bad_wire();
  faults.to_client.flipped = faults.from_client.flipped = 0.1;
  const CommandTrial trial = run_command_trial(robot(), 300, faults);
  EXPECT_GT(trial.done, 200u);
  EXPECT_GT(trial.refused, 5u);
  EXPECT_EQ(trial.done_twice, 0u);
  EXPECT_EQ(trial.lost, 0u);
  EXPECT_EQ(trial.done_in_secret, 0u);
}

TEST(BadWire, HasEveryWaypointOfEveryPathPassedOnceAndInOrderOrSaysWhyNot) {
  const FollowTrial trial = run_follow_trial(robot(), 20, bad_wire());
  EXPECT_GT(trial.followed, 10u);
  EXPECT_EQ(trial.reasons.size(), trial.refused + trial.ended_early);
  for (const std::string& reason : trial.reasons)
    EXPECT_FALSE(reason.empty());
  EXPECT_EQ(trial.twice, 0u);
  EXPECT_EQ(trial.out_of_order, 0u);
  EXPECT_EQ(trial.in_secret, 0u);
}
