// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "scan_cell_common/ros/node_main.h"
#include "triangulation_services.h"

int main(int argc, char** argv) {
  return scan_cell_common::node_main(argc, argv, "laser_triangulation", [] {
    ros::NodeHandle node;
    ros::NodeHandle private_node("~");
    constexpr int kThreads = 3;  // diagnostics, and a second call while one waits
    ros::AsyncSpinner spinner(kThreads);
    const laser_triangulation::TriangulationServices services(
        node, private_node, laser_triangulation::Parameters::load(private_node));
    spinner.start();
    ros::waitForShutdown();
  });
}
