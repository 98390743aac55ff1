// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/node_main.h"
#include "stretch_server.h"

int main(int argc, char** argv) {
  return scan_cell_common::node_main<tool_path_stretcher::StretchParameters>(
      argc, argv, "tool_path_stretcher",
      "Adapts a tool path proven on a reference part to a scanned object: an action.", [] {
        const tool_path_stretcher::StretchServer server(ros::NodeHandle("~"));
        ros::spin();
      });
}
