// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "binder_services.h"
#include "scan_cell_common/ros/node_main.h"

int main(int argc, char** argv) {
  return scan_cell_common::node_main(argc, argv, "pose_frame_binder", [] {
    ros::NodeHandle node;
    ros::NodeHandle private_node("~");
    constexpr int kThreads = 3;  // diagnostics, and a second call while one waits
    ros::AsyncSpinner spinner(kThreads);
    const pose_frame_binder::BinderServices services(
        node, private_node, pose_frame_binder::Parameters::load(private_node));
    spinner.start();
    ros::waitForShutdown();
  });
}
