// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "actions/calibrate_action.h"
#include "actions/scan_action.h"
#include "actions/work_action.h"
#include "scan_cell_common/ros/load_parameters.h"
#include "scan_cell_common/ros/node_main.h"
#include "scan_cell_common/ros/shutdown_request.h"
#include "services/grab_image.h"
#include "services/preview_work.h"
#include "services/record_pose.h"

int main(int argc, char** argv) {
  return scan_cell_common::node_main<scan_cell::Parameters>(
      argc, argv, "scan_cell",
      "Directs the cell: the actions for scans, calibrations and the work.", [] {
        ros::NodeHandle node("~");
        const auto parameters = scan_cell_common::load_parameters<scan_cell::Parameters>(node);
        constexpr int kThreads = 4;  // goals and cancels are received during a service call
        ros::AsyncSpinner spinner(kThreads);
        scan_cell::CellDevices devices(node, parameters);
        scan_cell::CellInUse cell;
        const scan_cell::StateTopic state(node);
        scan_cell::ScanAction scan(node, parameters, devices, cell, state);
        scan_cell::CalibrateAction calibrate(node, parameters, devices, cell, state);
        const scan_cell::WorkPlanner planner(parameters);
        scan_cell::WorkAction work(node, parameters, devices, planner, cell, state);
        const scan_cell::PreviewWork preview(node, parameters.base_frame, planner, devices.robot);
        const scan_cell::GrabImage grab_image(node, parameters, cell);
        const scan_cell::RecordPose record_pose(node, parameters.base_frame, devices.robot);
        scan_cell_common::take_over_shutdown();
        spinner.start();
        bool dropped = false;
        while (!scan_cell_common::shutdown_requested() && ros::ok()) {
          dropped = dropped || devices.robot.drop_earlier_goals();
          ros::WallDuration(0.02).sleep();
        }
      });
}
