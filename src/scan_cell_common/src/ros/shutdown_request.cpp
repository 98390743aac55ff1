// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/shutdown_request.h"

#include <ros/init.h>
#include <ros/names.h>
#include <ros/service_manager.h>
#include <ros/xmlrpc_manager.h>

#include <atomic>

#include "scan_cell_common/tools/interrupts.h"

namespace scan_cell_common {
namespace {

std::atomic<bool> requested{false};

void on_signal(int) {
  requested = true;
}

void shut_down(int number) {
  if (ros::isStarted() || ros::isShuttingDown()) {
    ros::requestShutdown();
    return;
  }
  // Nothing is in progress yet, and ros::start() would forget the request.
  signal(number, SIG_DFL);
  raise(number);
}

bool has_handler(int number) {
  struct sigaction present {};
  sigaction(number, nullptr, &present);
  return present.sa_handler != SIG_DFL && present.sa_handler != SIG_IGN;
}

}  // namespace

void set_up_process() {
  for (const int number : ending_signals()) {
    if (!has_handler(number)) signal(number, shut_down);
  }
  ros::ServiceManager::instance()->unadvertiseService(ros::names::resolve("~get_loggers"));
}

void take_over_shutdown() {
  for (const int number : ending_signals())
    signal(number, on_signal);
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
