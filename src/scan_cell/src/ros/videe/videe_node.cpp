// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "scan_cell_common/ros/load_parameters.h"
#include "scan_cell_common/ros/node_main.h"
#include "scan_cell_common/ros/shutdown_request.h"
#include "videe/videe_cell.h"
#include "videe/videe_server.h"

int main(int argc, char** argv) {
  return scan_cell_common::node_main<scan_cell::VideeParameters>(
      argc, argv, "videe",
      "Serves ViDeE over TCP: scans and calibrations for a client that has no ROS.", [] {
        ros::NodeHandle node("~");
        const auto parameters = scan_cell_common::load_parameters<scan_cell::VideeParameters>(node);
        scan_cell_common::take_over_shutdown();
        ros::AsyncSpinner spinner(2);
        spinner.start();
        scan_cell::VideeCell cell(node, parameters);
        const scan_cell::VideeServer server(
            parameters.server,
            [&cell](const auto& command, const auto& client_there) {
              return cell.carry_out(command, client_there);
            },
            [&cell] { cell.on_client_lost(); });
        ROS_INFO("ViDeE is served on %s:%u", parameters.server.address.c_str(), server.port());
        while (!scan_cell_common::shutdown_requested() && ros::ok())
          ros::WallDuration(0.02).sleep();
        // The server ends first, and with it the work of its client.
      });
}
