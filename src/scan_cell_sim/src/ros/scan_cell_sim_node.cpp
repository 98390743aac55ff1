// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/package.h>
#include <ros/ros.h>

#include "scan_cell_common/ros/load_parameters.h"
#include "scan_cell_common/ros/node_main.h"
#include "simulator_services.h"

int main(int argc, char** argv) {
  return scan_cell_common::node_main<scan_cell_sim::Parameters>(
      argc, argv, "scan_cell_sim",
      "Stands in for robot, camera, lasers and trigger circuit on the same wires.", [] {
        const ros::NodeHandle node("~");
        auto parameters = scan_cell_common::load_parameters<scan_cell_sim::Parameters>(node);
        complete(parameters, ros::package::getPath("scan_cell_sim") + "/config/");
        const scan_cell_sim::SimulatorServices simulator(node, parameters);
        ros::spin();
      });
}
