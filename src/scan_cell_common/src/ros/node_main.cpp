// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/node_main.h"

#include <ros/ros.h>

#include <exception>

namespace scan_cell_common {

int node_main(int argc, char** argv, const std::string& name, const std::function<void()>& body) {
  ros::init(argc, argv, name);
  // The last handle takes the console down with it: without this one the line below is not printed.
  const ros::NodeHandle keep_console;
  try {
    body();
    return 0;
  } catch (const std::exception& error) {
    ROS_FATAL("%s: %s", name.c_str(), error.what());
    return 1;
  }
}

}  // namespace scan_cell_common
