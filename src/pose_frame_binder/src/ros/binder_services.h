// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <scan_cell_msgs/FinishBinding.h>
#include <scan_cell_msgs/StartRun.h>
#include <scan_cell_msgs/StartScan.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>

#include "frame_lookup.h"
#include "parameters.h"
#include "static_transforms.h"

namespace pose_frame_binder {

/// The binder's topics and services. Data is received in its own thread, so that it arrives while
/// ~finish waits for it.
class BinderServices {
 public:
  /// @param node handle whose queue serves no topic with data
  BinderServices(ros::NodeHandle node, ros::NodeHandle private_node, const Parameters& parameters);

 private:
  bool start(scan_cell_msgs::StartScan::Request& request,
             scan_cell_msgs::StartScan::Response& response);
  bool check_run(scan_cell_msgs::StartRun::Request& request,
                 scan_cell_msgs::StartRun::Response& response);
  bool start_run(scan_cell_msgs::StartRun::Request& request,
                 scan_cell_msgs::StartRun::Response& response);
  bool finish(scan_cell_msgs::FinishBinding::Request& request,
              scan_cell_msgs::FinishBinding::Response& response);

  template <class Data>
  bool take(const Data& data);
  void wait_for_all(std::unique_lock<std::mutex>& lock, std::uint64_t triggers, double timeout);
  void publish_bound();  // call with the mutex held
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  const Parameters parameters_;
  ros::CallbackQueue data_queue_;
  StaticTransforms static_transforms_;

  std::mutex mutex_;
  std::condition_variable news_;
  std::unique_ptr<ProfileBinder> scan_;  // none between scans
  FrameLookup lookup_;
  std::string scan_id_;
  std::string failure_;  // why the current scan cannot be bound completely
  bool finishing_ = false;
  std::atomic<std::uint64_t> profiles_ignored_{0};  // since the last start
  Audit last_audit_;

  ros::Publisher bound_;
  ros::Publisher audit_;
  ros::Subscriber profiles_;
  ros::Subscriber events_;
  ros::Subscriber poses_;
  ros::ServiceServer start_;
  ros::ServiceServer check_run_;
  ros::ServiceServer start_run_;
  ros::ServiceServer finish_;
  diagnostic_updater::Updater diagnostics_;
  ros::Timer diagnostics_timer_;
  ros::AsyncSpinner data_spinner_{1, &data_queue_};
};

}  // namespace pose_frame_binder
