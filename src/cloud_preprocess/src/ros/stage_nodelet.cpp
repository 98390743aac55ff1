// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "stage_nodelet.h"

#include <scan_cell_common/errors/errors.h>
#include <scan_cell_msgs/PreprocessReport.h>

#include "stage_reports.h"

namespace cloud_preprocess {

void StageNodelet::start() {
  TargetFrame target;
  stage_ = make_stage(getPrivateNodeHandle(), target);
  frames_.set_target(target, getNodeHandle());
  constexpr bool kLatched = true;
  output_ = getPrivateNodeHandle().advertise<sensor_msgs::PointCloud2>("output", 1, kLatched);
  report_ =
      getPrivateNodeHandle().advertise<scan_cell_msgs::PreprocessReport>("report", 1, kLatched);
  input_ = getNodeHandle().subscribe("input", 2, &StageNodelet::on_cloud, this);
}

void StageNodelet::on_cloud(const sensor_msgs::PointCloud2ConstPtr& message) {
  std_msgs::Header header = message->header;
  StageReport report{stage_->name(), std::size_t{message->width} * message->height, 0, 0, ""};
  std::string failure;
  try {
    Eigen::Isometry3f motion;
    TracedCloud cloud = frames_.places_of(*message, motion);
    header = frames_.header_of(header);
    stage_->run(cloud, report);
    output_.publish(to_message(cloud, *message, motion, header));
  } catch (const scan_cell_common::Error& error) {
    failure = error.what();
    NODELET_ERROR("%s", error.what());
  }
  report_.publish(to_message(report, failure, header));
}

}  // namespace cloud_preprocess
