// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "trial_setup.h"

#include <chrono>
#include <thread>

#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {

ClientOptions options_for(const scan_cell_sim::Controller& controller,
                          const std::shared_ptr<const RobotModel>& robot) {
  ClientOptions options;
  options.port = controller.port();
  options.link_timeout = 2;  // [s] chosen, for a busy machine
  options.tries = 400;       // a retry every 5 ms
  options.robot = robot;
  options.limits.operation = Operation::kAutomatic;
  return options;
}

void wait_for_link(const Client& client) {
  const auto start = std::chrono::steady_clock::now();
  const std::chrono::duration<double> patience(kPatience);
  while (!client.link().up) {
    if (std::chrono::steady_clock::now() - start > patience)
      throw scan_cell_common::ConnectionError("emulated controller", client.link().message,
                                              "check the faults of its wire");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

Eigen::Isometry3d looking_down(double y) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << 0.80, y, 0.60;
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  return pose;
}

}  // namespace c4g_driver
