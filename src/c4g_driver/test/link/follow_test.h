// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <vector>

#include "c4g_driver/client.h"
#include "robot/smart5_six.h"
#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_sim/controller/controller.h"

/// The client follows tool paths on the emulated controller, over real sockets.
namespace c4g_driver {

class FollowTogether : public testing::Test {
 protected:
  void SetUp() override {
    scan_cell_sim::ControllerOptions controller;
    controller.port = 0;
    controller.witness = [this](const scan_cell_sim::TakenUp& taken) {
      const std::lock_guard<std::mutex> lock(mutex_);
      const bool begins = taken.datagram.find("FOLLOW_PATH") != std::string::npos;
      if (begins && !taken.refused) ++begun_;
    };
    controller_ = std::make_unique<scan_cell_sim::Controller>(controller);
    connect(2);
  }

  void connect(double link_timeout, double follow_watch = 1) {
    ClientOptions options;
    options.port = controller_->port();
    options.link_timeout = link_timeout;  // patience for a busy machine, as follow_watch
    options.follow_watch = follow_watch;
    options.tries = 100;
    options.robot = std::make_shared<RobotModel>(smart5_six());
    options.limits.operation = Operation::kAutomatic;
    client_ = std::make_unique<Client>(options, [this](const MeasuredState& state) {
      const std::lock_guard<std::mutex> lock(mutex_);
      heard_.push_back(state);
    });
    ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  }

  static bool eventually(const std::function<bool()>& condition) {
    for (int i = 0; i < 4000 && !condition(); ++i)
      usleep(5'000);
    return condition();
  }

  /// A zigzag from where the tip stands, with another output on each line.
  ToolMotion zigzag(std::size_t lines, double speed) const {
    ToolMotion motion;
    motion.flange_to_tip.translation() << 0.02, 0.01, 0.15;
    motion.flange_to_tip.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
    ToolWaypoint waypoint{controller_->state().flange * motion.flange_to_tip, speed, 0.001, 1};
    for (std::size_t i = 0; i <= lines; ++i) {
      motion.waypoints.push_back(waypoint);
      waypoint.tip.translation().y() += i % 2 == 0 ? 0.03 : 0;
      waypoint.tip.translation().x() += i % 2 == 0 ? 0 : 0.01;
      if (i % 4 == 2) waypoint.tip.translation().y() -= 0.06;
      waypoint.tip.rotate(Eigen::AngleAxisd(i % 2 == 0 ? 0.05 : -0.05, Eigen::Vector3d::UnitZ()));
      waypoint.outputs = static_cast<std::uint32_t>(i + 2);
    }
    return motion;
  }

  std::vector<MeasuredState> heard() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return heard_;
  }

  int begun() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return begun_;
  }

  /// Expects each waypoint once, in order, with its own outputs, in what was received about the
  /// motions since.
  /// @return the last waypoint
  std::uint64_t expect_in_order(const ToolMotion& motion) {
    std::uint64_t passed = 0, of = 0;
    for (const MeasuredState& state : heard()) {
      const RobotState& robot = state.robot;
      if (robot.motion != of) passed = 0;
      of = robot.motion;
      EXPECT_GE(robot.waypoint, passed);
      passed = robot.waypoint;
      EXPECT_TRUE(robot.outputs == 0 || robot.outputs == motion.waypoints.at(passed).outputs);
      EXPECT_TRUE(robot.status == MotionStatus::kMoving || robot.outputs == 0);
    }
    return passed;
  }

  std::mutex mutex_;
  std::vector<MeasuredState> heard_;
  int begun_ = 0;
  std::unique_ptr<scan_cell_sim::Controller> controller_;
  std::unique_ptr<Client> client_;
};

}  // namespace c4g_driver
