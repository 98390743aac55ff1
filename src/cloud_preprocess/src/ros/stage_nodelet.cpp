// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "stage_nodelet.h"

#include <scan_cell_common/errors.h>
#include <scan_cell_common/ros/cloud_messages.h>
#include <scan_cell_common/ros/logger_list.h>
#include <scan_cell_common/ros/shutdown_request.h>
#include <scan_cell_msgs/PreprocessReport.h>

namespace cloud_preprocess {

void StageNodelet::onInit() {
  scan_cell_common::shut_down_on_signals();
  scan_cell_common::withdraw_logger_list();
  scan_cell_common::ParameterReader reader(getPrivateNodeHandle());
  try {
    stage_ = make_stage(reader);
    reader.refuse_unknown();
  } catch (const scan_cell_common::Error& error) {
    NODELET_FATAL("%s", error.what());
    throw;  // the manager drops the nodelet, and the loading node ends
  }
  constexpr bool kLatched = true;
  output_ = getPrivateNodeHandle().advertise<sensor_msgs::PointCloud2>("output", 1, kLatched);
  report_ =
      getPrivateNodeHandle().advertise<scan_cell_msgs::PreprocessReport>("report", 1, kLatched);
  input_ = getNodeHandle().subscribe("input", 2, &StageNodelet::on_cloud, this);
}

void StageNodelet::on_cloud(const sensor_msgs::PointCloud2ConstPtr& message) {
  scan_cell_msgs::PreprocessReport result;
  result.header = message->header;
  result.stage = stage_->name();
  result.points_in = std::uint64_t{message->width} * message->height;
  try {
    StageReport report;
    const Cloud cloud = stage_->run(scan_cell_common::from_message(*message), report);
    result.ok = true;
    result.points_out = report.points_out;
    result.message = report.message;
    output_.publish(boost::make_shared<sensor_msgs::PointCloud2>(
        scan_cell_common::to_message(cloud, message->header)));
  } catch (const scan_cell_common::Error& error) {
    result.message = error.what();
    NODELET_ERROR("%s", error.what());
  }
  report_.publish(result);
}

}  // namespace cloud_preprocess
