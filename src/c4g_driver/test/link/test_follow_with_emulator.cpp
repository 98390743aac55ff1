// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Tool paths: the client against the emulated controller, with its faults.
#include "link/follow_test.h"

using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;

namespace c4g_driver {

using Outcome = Goal::Outcome;

TEST_F(FollowTogether, ReachTheEndOfAPathThroughEveryWaypoint) {
  const ToolMotion motion = zigzag(60, 0.3);
  client_->follow(motion);
  const Goal goal = client_->wait_for_goal(60);
  ASSERT_EQ(goal.outcome(), Outcome::kReached) << goal.message();
  EXPECT_EQ(goal.waypoint(), 60u);
  ASSERT_TRUE(eventually([this] { return heard().back().robot.waypoint == 60; }));
  EXPECT_EQ(expect_in_order(motion), 60u);
  const Eigen::Isometry3d tip = controller_->state().flange * motion.flange_to_tip;
  EXPECT_LT((tip.translation() - motion.waypoints.back().tip.translation()).norm(), 1e-6);
}

TEST_F(FollowTogether, TellEachWaypointWhereItsOutputsReallyBegan) {
  const ToolMotion motion = zigzag(12, 0.1);
  client_->follow(motion);
  ASSERT_EQ(client_->wait_for_goal(60).outcome(), Outcome::kReached);
  int compared = 0;
  for (const MeasuredState& state : heard()) {
    const auto instant = controller_->host_time(state.robot.controller_time / 1000);
    const bool switches = controller_->outputs_at(instant - 2000) !=
                          controller_->outputs_at(instant + 2000);  // the clock's microsecond
    if (switches) continue;
    EXPECT_EQ(state.robot.outputs, controller_->outputs_at(instant));
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST_F(FollowTogether, GoOnOnlyFromTheWaypointThatANewGoalSays) {
  const ToolMotion motion = zigzag(20, 0.1);
  client_->follow(motion);
  ASSERT_TRUE(eventually([this] { return client_->goal().waypoint() >= 5; }));
  client_->stop();
  const Goal stopped = client_->wait_for_goal(20);
  ASSERT_EQ(stopped.outcome(), Outcome::kStopped);
  const std::size_t next = stopped.waypoint() + 1;
  EXPECT_THROW(client_->follow(motion), Refused) << "the tip is not at its beginning";
  EXPECT_THROW(client_->follow(motion, next), Refused) << "nor at this waypoint";
  EXPECT_EQ(begun(), 1);
  client_->move_to_pose(motion.waypoints[next].tip * motion.flange_to_tip.inverse(), 0);
  ASSERT_EQ(client_->wait_for_goal(20).outcome(), Outcome::kReached);
  client_->follow(motion, next);
  EXPECT_TRUE(eventually([&] { return client_->goal().waypoint() >= next; }));
  const Goal goal = client_->wait_for_goal(60);
  EXPECT_EQ(goal.outcome(), Outcome::kReached) << goal.message();
  EXPECT_EQ(goal.waypoint(), 20u);
  EXPECT_EQ(begun(), 2);
}

TEST_F(FollowTogether, RefuseWhatIsNoPathBeforeAnythingIsSent) {
  const ToolMotion good = zigzag(5, 0.1);
  EXPECT_THROW(client_->follow({}), UnusableInput);
  EXPECT_THROW(client_->follow(good, 5), UnusableInput);
  EXPECT_THROW(client_->follow(good, 50), UnusableInput);
  const auto follow_with = [&](auto change) {
    ToolMotion motion = good;
    change(motion.waypoints[3]);
    client_->follow(motion);
  };
  EXPECT_THROW(follow_with([](auto& w) { w.speed = 0; }), UnusableInput);
  EXPECT_THROW(follow_with([](auto& w) { w.tip.translation().x() = std::nan(""); }), UnusableInput);
  EXPECT_THROW(follow_with([](auto& w) { w.zone = -1; }), UnusableInput);
  EXPECT_THROW(follow_with([](auto& w) { w.speed = 3; }), UnusableInput);
  EXPECT_THROW(follow_with([](auto& w) { w.tip.translation().x() += 3; }), Refused);
  EXPECT_THROW(client_->follow(good, 0, [] { return false; }), Refused) << "cancelled";
  EXPECT_EQ(controller_->motions_begun(), 0u);
  client_->follow(good);
  EXPECT_THROW(client_->follow(good), Refused) << "another is under way";
  EXPECT_EQ(client_->wait_for_goal(20).outcome(), Outcome::kReached);
}

}  // namespace c4g_driver
