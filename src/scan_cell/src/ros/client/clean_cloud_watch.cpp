// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "client/clean_cloud_watch.h"

#include <fmt/format.h>

#include <chrono>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell {

void check_published(const std::string& cloud_file) {
  if (cloud_file.empty()) return;
  throw scan_cell_common::Refused("cloud", "too large for a message, in " + cloud_file,
                                  "clean it with rosrun cloud_preprocess clean_cloud");
}

CleanCloudWatch::CleanCloudWatch(ros::NodeHandle node, const std::string& clean_cloud,
                                 const std::string& report)
    : clean_cloud_(clean_cloud) {
  cloud_subscriber_ = node.subscribe(clean_cloud, 10, &CleanCloudWatch::on_cloud, this);
  report_subscriber_ = node.subscribe(report, 100, &CleanCloudWatch::on_report, this);
}

void CleanCloudWatch::on_cloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  const std::lock_guard<std::mutex> lock(mutex_);
  clouds_[cloud->header.stamp] = cloud;
  news_.notify_all();
}

void CleanCloudWatch::on_report(const scan_cell_msgs::PreprocessReport& report) {
  if (report.ok) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  failures_[report.header.stamp] = report;
  news_.notify_all();
}

void CleanCloudWatch::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  clouds_.clear();
  failures_.clear();
}

sensor_msgs::PointCloud2 CleanCloudWatch::wait(const ros::Time& stamp, double timeout) {
  std::unique_lock<std::mutex> lock(mutex_);
  news_.wait_for(lock, std::chrono::duration<double>(timeout),
                 [&] { return clouds_.count(stamp) + failures_.count(stamp) > 0; });
  const auto failure = failures_.find(stamp);
  if (failure != failures_.end()) {
    throw scan_cell_common::Refused("preprocessing: " + failure->second.stage, "failed",
                                    failure->second.message);
  }
  const auto cloud = clouds_.find(stamp);
  if (cloud == clouds_.end()) {
    throw scan_cell_common::ConnectionError(clean_cloud_,
                                            fmt::format("no clean cloud within {:g} s", timeout),
                                            "is the nodelet of the preprocessing running?");
  }
  return *cloud->second;
}

}  // namespace scan_cell
