// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "c4g_driver/client.h"
#include "link/fake_controller.h"
#include "robot/smart5_six.h"
#include "scan_cell_common/clock/host_clock.h"

/// The client against a scripted controller on real sockets.
namespace c4g_driver {

using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using std::chrono::steady_clock;

inline bool eventually(const std::function<bool()>& condition, double seconds = 10) {
  const auto deadline = steady_clock::now() + std::chrono::duration<double>(seconds);
  while (steady_clock::now() < deadline) {
    if (condition()) return true;
    usleep(2000);
  }
  return condition();
}

/// All poses that the client delivered.
class Heard {
 public:
  void operator()(const MeasuredState& state) {
    const std::lock_guard<std::mutex> lock(mutex_);
    states_.push_back(state);
  }
  std::vector<MeasuredState> states() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return states_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<MeasuredState> states_;
};

class ClientTest : public testing::Test {
 protected:
  ClientOptions options(std::uint16_t port) const {
    ClientOptions result;
    result.port = port;
    result.reconnect_period = 0.05;
    result.link_timeout = link_timeout_;
    result.robot = robot_;
    result.limits.operation = Operation::kAutomatic;
    return result;
  }

  void connect() {
    client_ = std::make_unique<Client>(options(controller_->port()),
                                       [this](const MeasuredState& state) { heard_(state); });
    ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  }

  bool poses_heard_at(const std::vector<std::int64_t>& microseconds) {
    std::vector<std::int64_t> times;
    for (const MeasuredState& state : heard_.states()) {
      if (state.robot.controller_time >= 1'000'000'000'000)  // polls are in the first seconds
        times.push_back(state.robot.controller_time / 1000);
    }
    return times == microseconds;
  }

  /// A stream that a test writes by hand is ahead of the polls' time, so polls are dropped.
  static constexpr double kPatient = 20;

  void TearDown() override { hold_ = false; }

  std::atomic<bool> hold_{false};  // a listener that takes its time
  std::atomic<bool> held_{false};
  Heard heard_;
  double link_timeout_ = 0.5;
  std::shared_ptr<const RobotModel> robot_ = std::make_shared<RobotModel>(smart5_six());
  std::unique_ptr<FakeController> controller_ = std::make_unique<FakeController>();
  std::unique_ptr<Client> client_;
};

}  // namespace c4g_driver
