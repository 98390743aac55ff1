// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <atomic>
#include <csignal>
#include <iostream>

#include "scan_cell_common/ros/node_main.h"
#include "trigger_services.h"

namespace {

std::atomic<bool> interrupted{false};

void on_signal(int) {
  interrupted = true;
}

void serve(laser_trigger::Guardian& guardian) {
  using namespace laser_trigger;
  ros::NodeHandle node("~");
  const Parameters parameters = Parameters::load(node);
  guardian.watch(parameters.port, parameters.hang_timeout);
  const std::unique_ptr<TriggerPort> port = open_port(parameters.port);
  try {
    port->write(0);
  } catch (const NoDevice& error) {
    // A simulator that is not there yet has no lasers on; a parallel port must be there.
    if (parameters.port.kind == PortAddress::Kind::Parallel) throw;
    ROS_WARN("%s", error.what());
  }
  TriggerServices services(node, parameters, *port, guardian);
  for (const int number : {SIGINT, SIGTERM, SIGHUP})
    std::signal(number, on_signal);  // in place of roscpp's, so that the lines go low first
  constexpr int kThreads = 2;        // the keep-alive is heard while a service call is under way
  ros::AsyncSpinner spinner(kThreads);
  spinner.start();
  while (!interrupted && ros::ok())
    ros::WallDuration(0.02).sleep();
  services.shut_down("the trigger node was stopped");
  spinner.stop();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    laser_trigger::Guardian guardian;  // before there are threads
    return scan_cell_common::node_main(argc, argv, "laser_trigger",
                                       [&guardian] { serve(guardian); });
  } catch (const std::exception& error) {
    std::cerr << "laser_trigger: " << error.what() << '\n';
    return 1;
  }
}
