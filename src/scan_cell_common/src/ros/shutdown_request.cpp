// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/shutdown_request.h"

#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <csignal>

namespace scan_cell_common {
namespace {

std::atomic<bool> requested{false};

void on_signal(int) {
  requested = true;
}

}  // namespace

void take_over_shutdown() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  const auto manager = ros::XMLRPCManager::instance();
  manager->unbind("shutdown");
  manager->bind("shutdown", [](XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue& answer) {
    requested = true;
    answer = ros::xmlrpc::responseInt(1, "", 0);
  });
}

bool shutdown_requested() {
  return requested;
}

}  // namespace scan_cell_common
