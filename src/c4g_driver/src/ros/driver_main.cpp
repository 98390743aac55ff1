// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_node.h"
#include "scan_cell_common/ros/node_main.h"

int main(int argc, char** argv) {
  return scan_cell_common::node_main<c4g_driver::DriverParameters>(
      argc, argv, "c4g_driver",
      "Speaks C4G with the robot controller: publishes where the robot is, and moves it.", [] {
        const ros::NodeHandle private_node("~");
        const c4g_driver::DriverNode driver(ros::NodeHandle(), private_node,
                                            c4g_driver::DriverParameters::load(private_node));
        ros::spin();
      });
}
