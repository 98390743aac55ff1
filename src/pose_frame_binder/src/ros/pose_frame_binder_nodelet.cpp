// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <exception>
#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "binder_services.h"

namespace pose_frame_binder {

/// The node's topics and services in a manager's process. Its calls have threads of their own: one
/// that waits never holds up the manager's others, however few workers it has.
class BinderNodelet : public nodelet::Nodelet {
  void onInit() override {
    try {
      ros::NodeHandle node = getNodeHandle();
      ros::NodeHandle private_node = getPrivateNodeHandle();
      node.setCallbackQueue(&queue_);
      private_node.setCallbackQueue(&queue_);
      services_ =
          std::make_unique<BinderServices>(node, private_node, Parameters::load(private_node));
    } catch (const std::exception& error) {
      NODELET_FATAL("%s", error.what());
      throw;
    }
    spinner_.start();
  }

  static constexpr int kThreads = 3;  // diagnostics, and a second call while one waits

  ros::CallbackQueue queue_;
  std::unique_ptr<BinderServices> services_;
  ros::AsyncSpinner spinner_{kThreads, &queue_};  // last: its threads use the above
};

}  // namespace pose_frame_binder

PLUGINLIB_EXPORT_CLASS(pose_frame_binder::BinderNodelet, nodelet::Nodelet)
