// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// What the robot does when the driver ends in any way.
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "node/driver_node_test.h"
#include "scan_cell_common/testing/child_process.h"

using namespace driver_node_test;  // NOLINT

namespace {

/// A driver in its own process, and its controller.
class DriverEnding : public testing::Test {
 protected:
  DriverEnding() {
    scan_cell_sim::ControllerOptions options;
    options.port = kPort;
    options.witness = [this](const scan_cell_sim::TakenUp& taken) {
      const std::lock_guard<std::mutex> lock(mutex_);
      const std::string command = nlohmann::json::parse(taken.datagram)["cmd"];
      if (command != "GET_STATIC_POSE") commands_.push_back(command);
    };
    controller_ = std::make_unique<scan_cell_sim::Controller>(options);
  }

  void start_driver() {
    const std::size_t before = status_.all().size();
    const auto node_beside_this_test =
        std::filesystem::read_symlink("/proc/self/exe").parent_path() / "c4g_driver_node";
    driver_ = std::make_unique<scan_cell_common::ChildProcess>(
        std::vector<std::string>{node_beside_this_test, "__name:=mortal", "_address:=127.0.0.1",
                                 "_port:=" + std::to_string(kPort)});
    const auto connected = [&] {
      return status_.all().size() > before + 10 &&
             status_.is([](const RobotStatus& now) { return now.connected; });
    };
    ASSERT_TRUE(eventually(connected));
  }

  void start_long_move() {
    ASSERT_TRUE(move_.waitForServer(kPatience));
    move_.sendGoal(to_pose(looking_down(0.80, 0.35, 0.60)));
    ASSERT_TRUE(
        eventually([this] { return controller_->state().flange.translation().y() > 0.03; }));
  }

  /// @return its exit code, or 128 and the signal that killed it
  int end_driver(int signal) {
    kill(driver_->id(), signal);
    return driver_->wait();
  }

  std::vector<std::string> commands() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return commands_;
  }

  static constexpr int kPort = 35413;
  ros::NodeHandle node_;
  mutable std::mutex mutex_;
  std::vector<std::string> commands_;
  std::unique_ptr<scan_cell_sim::Controller> controller_;
  Latest<RobotStatus> status_{node_, "/mortal/status"};
  MoveClient move_{"/mortal/move", true};
  std::unique_ptr<scan_cell_common::ChildProcess> driver_;
};

class DriverEndingBySignal : public DriverEnding, public testing::WithParamInterface<int> {};

}  // namespace

TEST_P(DriverEndingBySignal, StopsTheRobotAndClosesTheSession) {
  signal(GetParam(), SIG_DFL);  // under nohup the tests, and so the driver, would ignore it
  ASSERT_NO_FATAL_FAILURE(start_driver());
  ASSERT_NO_FATAL_FAILURE(start_long_move());
  EXPECT_EQ(end_driver(GetParam()), 0);
  const std::vector<std::string> seen = commands();
  ASSERT_GE(seen.size(), 3u);
  EXPECT_EQ(seen[seen.size() - 3], "MOVE_CARTESIAN");
  EXPECT_EQ(seen[seen.size() - 2], "STOP");
  EXPECT_EQ(seen[seen.size() - 1], "CLOSE");
  EXPECT_LT(controller_->state().flange.translation().y(), 0.34);
}

INSTANTIATE_TEST_SUITE_P(Signals, DriverEndingBySignal, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST_F(DriverEnding, ByKillLeavesNothingThatMovesTheRobotWhenItIsStartedAgain) {
  ASSERT_NO_FATAL_FAILURE(start_driver());
  ASSERT_NO_FATAL_FAILURE(start_long_move());
  end_driver(SIGKILL);
  ASSERT_TRUE(eventually(
      [&] { return controller_->state().status == scan_cell_sim::MotionStatus::kStopped; }));
  const Eigen::Isometry3d stopped = controller_->state().flange;
  EXPECT_LT(stopped.translation().y(), 0.349);
  ASSERT_NO_FATAL_FAILURE(start_driver());
  EXPECT_EQ(distance(controller_->state().flange, stopped), 0);
  EXPECT_EQ(controller_->motions_begun(), 1u);
}
