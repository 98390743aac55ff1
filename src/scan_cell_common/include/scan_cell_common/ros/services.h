// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <memory>
#include <string>

#include "scan_cell_common/ros/load_parameters.h"
#include "scan_cell_common/ros/node_main.h"
#include "scan_cell_common/ros/nodelet.h"

/// Runs a node's topics and services, a class with a constructor (node, private node, parameters),
/// in a process of their own or in a nodelet manager.
namespace scan_cell_common {

/// Threads for calls: diagnostics, and a second call while one waits.
constexpr int kServiceThreads = 3;

/// The main() of a node, as node_main().
template <class Services, class Parameters>
int services_main(int argc, char** argv, const std::string& name, const std::string& description) {
  return node_main<Parameters>(argc, argv, name, description, [] {
    ros::NodeHandle node;
    ros::NodeHandle private_node("~");
    const Services services(node, private_node, load_parameters<Parameters>(private_node));
    ros::AsyncSpinner spinner(kServiceThreads);  // last: calls end before the services do
    spinner.start();
    ros::waitForShutdown();
  });
}

/// The same in a nodelet manager. Its calls have their own threads, so that a waiting call never
/// blocks the manager's other nodelets, however few workers it has.
template <class Services, class Parameters>
class ServicesNodelet : public Nodelet {
  void start() override {
    ros::NodeHandle node = getNodeHandle();
    ros::NodeHandle private_node = getPrivateNodeHandle();
    node.setCallbackQueue(&queue_);
    private_node.setCallbackQueue(&queue_);
    services_ =
        std::make_unique<Services>(node, private_node, load_parameters<Parameters>(private_node));
    spinner_.start();
  }

  ros::CallbackQueue queue_;
  std::unique_ptr<Services> services_;
  ros::AsyncSpinner spinner_{kServiceThreads, &queue_};  // last, since its threads use the above
};

}  // namespace scan_cell_common
