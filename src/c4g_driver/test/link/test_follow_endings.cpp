// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Whatever ends a followed path, the outputs are off, the robot stands, and nothing goes on.
#include "link/follow_test.h"

namespace c4g_driver {

using Outcome = Goal::Outcome;
using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;

namespace {

constexpr Nanoseconds kMillisecond = 1'000'000;

class FollowEndings : public FollowTogether {
 protected:
  /// Starts a path and waits until it is well under way.
  void start() {
    motion_ = zigzag(60, 0.1);
    client_->follow(motion_);
    ASSERT_TRUE(eventually([this] { return controller_->state().waypoint >= 3; }));
    ASSERT_NE(controller_->outputs_at(host_now()), 0u);
  }

  /// Expects, by the emulator's truth, outputs off and the robot standing within these times [ms]
  /// after an instant, permanently.
  void expect_it_ends(Nanoseconds instant, int off, int standing) {
    ASSERT_TRUE(eventually([&] { return host_now() > instant + 1500 * kMillisecond; }));
    for (int after = off; after < 1500; after += 5)
      EXPECT_EQ(controller_->outputs_at(instant + after * kMillisecond), 0u) << after << " ms";
    const Eigen::Isometry3d rest = controller_->flange_at(instant + standing * kMillisecond);
    for (int after = standing; after < 1500; after += 50)
      EXPECT_TRUE(controller_->flange_at(instant + after * kMillisecond).isApprox(rest, 1e-12));
    EXPECT_TRUE(controller_->flange_at(host_now()).isApprox(rest, 1e-12));
    EXPECT_EQ(controller_->motions_begun(), 1u);
    EXPECT_EQ(controller_->outputs_at(host_now()), 0u);
  }

  ToolMotion motion_;
};

}  // namespace

TEST_F(FollowEndings, EmergencyStopTurnsTheOutputsOffAtOnceAndForGood) {
  start();
  const Nanoseconds pressed = host_now();
  controller_->press_e_stop();
  const Goal goal = client_->wait_for_goal(20);
  EXPECT_EQ(goal.outcome(), Outcome::kStopped);
  EXPECT_EQ(goal.message(), "emergency stop");
  controller_->release_e_stop();
  client_->reset_alarms();
  client_->set_drives(true);
  expect_it_ends(pressed, 100, 500);
}

TEST_F(FollowEndings, StopTurnsTheOutputsOff) {
  start();
  client_->stop();
  const Nanoseconds stopped = host_now();
  EXPECT_EQ(client_->wait_for_goal(20).outcome(), Outcome::kStopped);
  expect_it_ends(stopped, 0, 500);
}

TEST_F(FollowEndings, ALostLinkEndsThePathWhenItsWatchIsOver) {
  client_.reset();
  connect(2, 0.3);
  start();
  scan_cell_sim::ControllerFaults cut;
  cut.to_client.link_down = cut.from_client.link_down = true;
  controller_->set_faults(cut);
  const Nanoseconds instant = host_now();
  EXPECT_EQ(client_->wait_for_goal(20).outcome(), Outcome::kLinkLost);
  controller_->set_faults({});
  ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  expect_it_ends(instant, 400, 900);
}

TEST_F(FollowEndings, ASilenceThatIsShorterThanItsWatchDoesNotEndIt) {
  start();
  scan_cell_sim::ControllerFaults deaf;
  deaf.from_client.silence = 0.4;
  controller_->set_faults(deaf);
  EXPECT_EQ(client_->wait_for_goal(60).outcome(), Outcome::kReached);
}

TEST_F(FollowEndings, AClientThatIsGoneEndsIt) {
  start();
  const Nanoseconds instant = host_now();
  client_.reset();
  expect_it_ends(instant, 200, 700);
  connect(2);
  EXPECT_EQ(client_->goal().outcome(), Outcome::kNone);
  EXPECT_EQ(controller_->motions_begun(), 1u);
}

TEST_F(FollowEndings, ARestartOfTheControllerEndsIt) {
  start();
  const Nanoseconds instant = host_now();
  controller_->restart(0.3);
  EXPECT_EQ(client_->wait_for_goal(20).outcome(), Outcome::kLinkLost);
  ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  expect_it_ends(instant, 100, 500);
}

TEST_F(FollowEndings, AFaultOfTheRobotEndsItInAnError) {
  start();
  const Nanoseconds instant = host_now();
  controller_->fail_motion("following error of J2");
  const Goal goal = client_->wait_for_goal(20);
  EXPECT_EQ(goal.outcome(), Outcome::kFailed);
  EXPECT_EQ(goal.message(), "following error of J2");
  expect_it_ends(instant, 100, 500);
}

TEST_F(FollowEndings, AnotherModeEndsIt) {
  start();
  const Nanoseconds instant = host_now();
  controller_->select(scan_cell_sim::ControllerMode::kAutomatic);
  EXPECT_EQ(client_->wait_for_goal(20).outcome(), Outcome::kStopped);
  expect_it_ends(instant, 100, 500);
}

}  // namespace c4g_driver
