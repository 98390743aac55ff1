// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "scan_cell_common/ros/node_main.h"
#include "simulator_services.h"

int main(int argc, char** argv) {
  return scan_cell_common::node_main(
      argc, argv, "scan_cell_sim",
      "Stands in for robot, camera, lasers and trigger circuit on the same wires.", [] {
        const ros::NodeHandle node("~");
        const scan_cell_sim::SimulatorServices simulator(node,
                                                         scan_cell_sim::Parameters::load(node));
        ros::spin();
      });
}
