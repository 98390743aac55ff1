// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <atomic>
#include <csignal>

#include "scan_action.h"
#include "scan_cell_common/ros/node_main.h"

namespace {

std::atomic<bool> interrupted{false};

/// In place of roscpp's handler, which would cut the cell off before the scan under way is made
/// safe.
void on_interrupt(int) {
  interrupted = true;
}

}  // namespace

int main(int argc, char** argv) {
  return scan_cell_common::node_main(argc, argv, "scan_cell", [] {
    ros::NodeHandle node("~");
    const scan_cell::Parameters parameters = scan_cell::Parameters::load(node);
    constexpr int kThreads = 4;  // goals and cancels are heard while a service call is under way
    ros::AsyncSpinner spinner(kThreads);
    scan_cell::ScanAction scan(node, parameters);
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    spinner.start();
    while (!interrupted && ros::ok())
      ros::WallDuration(0.02).sleep();
  });
}
