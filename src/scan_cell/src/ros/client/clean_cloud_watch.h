// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/PreprocessReport.h>
#include <sensor_msgs/PointCloud2.h>

#include <condition_variable>
#include <map>
#include <mutex>
#include <string>

namespace scan_cell {

/// @param cloud_file of a scan's result
/// @throw scan_cell_common::Refused if it is set, since such a cloud is not published
void check_published(const std::string& cloud_file);

/// Receives the results of preprocessing. Create it before the cloud is published.
class CleanCloudWatch {
 public:
  CleanCloudWatch(ros::NodeHandle node, const std::string& clean_cloud, const std::string& report);

  /// Forgets what it has received. If the raw cloud has the stamp of an earlier one, as in replay,
  /// the latched clean cloud of the earlier one would be taken for its result. Call it just before
  /// the raw cloud is made.
  void forget();

  /// The clean cloud of the raw one with this stamp.
  /// @throw scan_cell_common::Refused with the reason of the stage that failed
  /// @throw scan_cell_common::ConnectionError if nothing arrives within `timeout` [s]
  sensor_msgs::PointCloud2 wait(const ros::Time& stamp, double timeout);

 private:
  void on_cloud(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void on_report(const scan_cell_msgs::PreprocessReport& report);

  std::string clean_cloud_;
  std::mutex mutex_;
  std::condition_variable news_;
  std::map<ros::Time, sensor_msgs::PointCloud2ConstPtr> clouds_;
  std::map<ros::Time, scan_cell_msgs::PreprocessReport> failures_;
  // last: their callbacks use the other members, even during destruction
  ros::Subscriber cloud_subscriber_;
  ros::Subscriber report_subscriber_;
};

}  // namespace scan_cell
