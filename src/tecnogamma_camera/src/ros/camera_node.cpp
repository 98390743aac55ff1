// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/loader.h>
#include <ros/ros.h>

#include <stdexcept>

#include "parameters.h"
#include "scan_cell_common/ros/node_main.h"

/// The nodelet tecnogamma_camera/Camera as a node of its own.
int main(int argc, char** argv) {
  return scan_cell_common::node_main<tecnogamma_camera::Parameters>(
      argc, argv, "tecnogamma_camera",
      "Grabs from a GigE Vision camera, or a recording, and publishes images and laser line "
      "profiles.",
      [] {
        nodelet::Loader loader(false);
        if (!loader.load(ros::this_node::getName(), "tecnogamma_camera/Camera",
                         ros::names::getRemappings(), {})) {
          throw std::runtime_error("the camera could not be set up; see the error above");
        }
        ros::spin();
      });
}
