// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <scan_cell_common/ros/nodelet.h>
#include <std_srvs/Trigger.h>

#include <mutex>
#include <string>
#include <vector>

#include "cloud_frames.h"
#include "cloud_preprocess/clean.h"

namespace cloud_preprocess {

struct CleanNodeletParameters {
  TargetFrame target;
  bool reduce = false;  //!< whether to use the grid
  CleanParameters stages;
};

void describe(scan_cell_common::ParameterTable& table, CleanNodeletParameters& parameters);

/// The whole chain as one nodelet. Subscribes `input`; publishes `~clean_cloud`, `~objects` and one
/// `~report` per stage, all latched. On a failure it publishes a report with the reason and no
/// cloud. `~apply` reloads the parameters and cleans the latest cloud again.
class CleanNodelet final : public scan_cell_common::Nodelet {
 private:
  void start() override;
  void on_cloud(const sensor_msgs::PointCloud2ConstPtr& message);
  bool apply(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  /// @return why it failed; empty if it did not
  std::string clean_and_publish(const sensor_msgs::PointCloud2& message);
  void run(const sensor_msgs::PointCloud2& message, std_msgs::Header& header,
           std::vector<StageReport>& reports);

  std::mutex mutex_;  // guards the members below: a service and a cloud may arrive at the same time
  CleanNodeletParameters parameters_;
  CloudFrames frames_;
  sensor_msgs::PointCloud2ConstPtr latest_;
  ros::Publisher clean_cloud_;
  ros::Publisher objects_;
  ros::Publisher report_;
  ros::Subscriber input_;
  ros::ServiceServer apply_;
};

}  // namespace cloud_preprocess
