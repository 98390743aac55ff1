// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <scan_cell_msgs/FinishCloud.h>
#include <scan_cell_msgs/StartRun.h>
#include <scan_cell_msgs/StartScan.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>

#include "cloud_builder.h"
#include "parameters.h"

namespace laser_triangulation {

/// The triangulation's topics and services. Profiles are received in a separate thread, so that
/// they arrive while ~finish waits for them.
class TriangulationServices {
 public:
  /// @param node its queue serves no data topic
  TriangulationServices(ros::NodeHandle node, ros::NodeHandle private_node,
                        const Parameters& parameters);

 private:
  bool start(scan_cell_msgs::StartScan::Request& request,
             scan_cell_msgs::StartScan::Response& response);
  bool check_run(scan_cell_msgs::StartRun::Request& request,
                 scan_cell_msgs::StartRun::Response& response);
  bool finish(scan_cell_msgs::FinishCloud::Request& request,
              scan_cell_msgs::FinishCloud::Response& response);
  void on_profile(const scan_cell_msgs::BoundProfile& profile);
  void wait_for(std::uint64_t profiles, double timeout, std::unique_lock<std::mutex>& lock);
  std::string find_fault(const CloudBuilder& scan, std::uint64_t profiles) const;
  void give_cloud(CloudBuilder& scan, scan_cell_msgs::FinishCloud::Response& response) const;
  void fill(const CloudBuilder& scan, const scan_cell_msgs::FinishCloud::Request& request,
            scan_cell_msgs::FinishCloud::Response& response);
  void tell(const scan_cell_msgs::FinishCloud::Response& response) const;
  void publish_increment();  // requires the mutex to be held
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  const Parameters parameters_;
  const scan_cell_common::ScannerModel model_;
  const std::vector<double> deviations_;  // [m] standard deviations of a scanned point, by laser
  ros::CallbackQueue data_queue_;

  std::mutex mutex_;
  std::condition_variable news_;
  std::unique_ptr<CloudBuilder> scan_;  // null between scans, and while its passes are compared
  std::string scan_id_;
  std::string failure_;        // why the scan's cloud is incomplete
  std::size_t published_ = 0;  // points published on ~cloud
  bool finishing_ = false;
  scan_cell_msgs::CloudStatistics last_;  // of the last finished scan
  std::uint64_t ignored_ = 0;

  ros::Publisher cloud_;
  ros::Publisher whole_cloud_;
  ros::Subscriber profiles_;
  ros::ServiceServer start_;
  ros::ServiceServer check_run_;
  ros::ServiceServer finish_;
  ros::WallTimer increment_timer_;
  diagnostic_updater::Updater diagnostics_;
  ros::Timer diagnostics_timer_;
  ros::AsyncSpinner data_spinner_{1, &data_queue_};
};

}  // namespace laser_triangulation
