// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <csignal>

#include "calibrate_action.h"
#include "grab_image.h"
#include "scan_action.h"
#include "scan_cell_common/ros/node_main.h"

namespace {

std::atomic<bool> interrupted{false};

/// In place of roscpp's handler, which would cut the cell off before the scan under way is made
/// safe.
void on_interrupt(int) {
  interrupted = true;
}

/// The same for a shutdown over XML-RPC: rosnode kill, or a second node of this name.
void take_over_shutdown() {
  const auto manager = ros::XMLRPCManager::instance();
  manager->unbind("shutdown");
  manager->bind("shutdown", [](XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue& answer) {
    interrupted = true;
    answer = ros::xmlrpc::responseInt(1, "", 0);
  });
}

}  // namespace

int main(int argc, char** argv) {
  return scan_cell_common::node_main(argc, argv, "scan_cell", [] {
    ros::NodeHandle node("~");
    const scan_cell::Parameters parameters = scan_cell::Parameters::load(node);
    constexpr int kThreads = 4;  // goals and cancels are heard while a service call is under way
    ros::AsyncSpinner spinner(kThreads);
    scan_cell::CellDevices devices(node, parameters);
    scan_cell::CellInUse cell;
    scan_cell::ScanAction scan(node, parameters, devices, cell);
    scan_cell::CalibrateAction calibrate(node, parameters, devices, cell);
    const scan_cell::GrabImage grab_image(node, parameters, cell);
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    take_over_shutdown();
    spinner.start();
    bool dropped = false;
    while (!interrupted && ros::ok()) {
      dropped = dropped || devices.robot.drop_earlier_goals();
      ros::WallDuration(0.02).sleep();
    }
  });
}
