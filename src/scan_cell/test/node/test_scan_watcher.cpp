// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// A scan whose client dies.
#include <scan_cell_msgs/CellState.h>

#include <csignal>
#include <filesystem>

#include "node/scan_client.h"
#include "scan_cell/ros/cell_watcher.h"
#include "scan_cell_common/testing/child_process.h"

using namespace scan_test;  // NOLINT
using scan_cell_common::ChildProcess;

namespace {

const char* const kListen = "--listen";
const char* const kState = "/scan_cell/state";

std::string own_program() {
  return std::filesystem::read_symlink("/proc/self/exe");
}

class ScanWatcher : public ScanClient {
 protected:
  void SetUp() override {
    ScanClient::SetUp();
    node_.setParam("/fake/move_time", 8.0);
  }

  static scan_cell_msgs::ScanGoal watched_goal(const std::string& watcher) {
    scan_cell_msgs::ScanGoal watched = goal("watched");
    watched.watcher = watcher;
    return watched;
  }

  /// Expects that the scan has ended without a client's cancel.
  void expect_ended_because_gone(const std::string& watcher) {
    EXPECT_TRUE(logged("disarmed"));
    EXPECT_TRUE(logged("stopped"));
    EXPECT_TRUE(logged("cloud partial"));
    ASSERT_TRUE(client_.waitForResult(ros::Duration(30)));
    EXPECT_EQ(client_.getState().state_, State::PREEMPTED);
    EXPECT_EQ(client_.getResult()->outcome, ScanResult::CANCELLED);
    EXPECT_EQ(client_.getResult()->message, "cancelled: " + watcher + " is gone");
    EXPECT_FALSE(client_.getResult()->cloud.data.empty());
  }
};

}  // namespace

TEST_F(ScanWatcher, IsRefusedByNameWhereItDoesNotListen) {
  const ScanResult refused = run(watched_goal("/nobody"));
  EXPECT_EQ(client_.getState().state_, State::REJECTED);
  EXPECT_EQ(refused.message,
            "watcher: '/nobody', which does not listen to the state; subscribe to " +
                std::string(kState) + " first, or give none");
  node_.setParam("/fake/move_time", 0.1);
  EXPECT_EQ(run(goal("after a refusal")).outcome, ScanResult::FINISHED);
}

TEST_F(ScanWatcher, MayHaveBegunToListenOnlyJustBeforeTheGoal) {
  node_.setParam("/fake/move_time", 0.1);
  for (int i = 0; i < 5; ++i) {
    const scan_cell::CellWatcher watcher(node_, kState);
    EXPECT_EQ(run(watched_goal(watcher.name(20))).outcome, ScanResult::FINISHED);
  }
}

TEST_F(ScanWatcher, DiesAndTheScanIsCancelled) {
  ChildProcess watcher({own_program(), kListen, "__name:=watcher"});
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(30);
  do {  // until it listens
    ASSERT_LT(ros::WallTime::now(), deadline);
    client_.sendGoal(watched_goal("/watcher"));
  } while (client_.waitForResult(ros::Duration(1.5)));
  ASSERT_TRUE(logged("armed"));
  kill(watcher.id(), SIGKILL);
  watcher.wait();
  expect_ended_because_gone("/watcher");
}

TEST_F(ScanWatcher, GoesAndTheScanIsCancelled) {
  auto watcher = std::make_unique<scan_cell::CellWatcher>(node_, kState);
  start(client_, watched_goal(watcher->name(20)));
  watcher.reset();
  expect_ended_because_gone(ros::this_node::getName());
}

TEST_F(ScanWatcher, IsTheToolThatScansWhoseEndIsNoticedHoweverItDies) {
  ChildProcess tool({SCAN_TOOL, "--program", SCAN_PROGRAM});
  ASSERT_TRUE(logged("armed"));
  kill(tool.id(), SIGKILL);
  EXPECT_EQ(tool.wait(), 128 + SIGKILL);
  EXPECT_TRUE(logged("disarmed"));
  EXPECT_TRUE(logged("stopped"));
  EXPECT_TRUE(logged("cloud partial"));
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_scan_watcher");
  if (argc > 1 && argv[1] == std::string(kListen)) {
    const scan_cell::CellWatcher watcher(ros::NodeHandle(), kState);
    ros::spin();
    return 0;
  }
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
