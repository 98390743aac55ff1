// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <optional>

#include "scan_cell_common/ros/load_parameters.h"
#include "scan_cell_common/ros/node_main.h"
#include "scan_cell_common/ros/shutdown_request.h"
#include "trigger_services.h"

namespace {

void serve(laser_trigger::Guardian& guardian) {
  using namespace laser_trigger;
  ros::NodeHandle node("~");
  const Parameters parameters = scan_cell_common::load_parameters<Parameters>(node);
  guardian.watch(parameters.port, parameters.hang_timeout);
  const std::unique_ptr<TriggerPort> port = open_port(parameters.port);
  try {
    port->write(0);
  } catch (const NoDevice& error) {
    // A simulator that is not running yet has no lasers on; a parallel port must exist.
    if (parameters.port.kind == PortAddress::Kind::kParallel) throw;
    ROS_WARN("%s", error.what());
  }
  TriggerServices services(node, parameters, *port, guardian);
  scan_cell_common::take_over_shutdown();  // so that the lines go low before ROS shuts down
  constexpr int kThreads = 2;              // so that a service call does not block the keep-alive
  constexpr double kLook = 0.02;           // [s] between two checks for a shutdown; chosen
  ros::AsyncSpinner spinner(kThreads);
  spinner.start();
  while (!scan_cell_common::shutdown_requested() && ros::ok())
    ros::WallDuration(kLook).sleep();
  services.shut_down("the trigger node was stopped");
  spinner.stop();
}

}  // namespace

int main(int argc, char** argv) {
  std::optional<laser_trigger::Guardian> guardian;
  return scan_cell_common::node_main<laser_trigger::Parameters>(
      argc, argv, "laser_trigger", "Pulses the camera, and switches the lasers on and off.",
      [&guardian] { serve(*guardian); }, [&guardian] { guardian.emplace(); });
}
