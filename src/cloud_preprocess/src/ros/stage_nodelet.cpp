// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "stage_nodelet.h"

#include <fmt/format.h>
#include <pcl/common/transforms.h>
#include <scan_cell_common/errors/errors.h>
#include <scan_cell_common/ros/cloud_messages.h>
#include <scan_cell_common/ros/conversions.h>
#include <scan_cell_msgs/PreprocessReport.h>

namespace cloud_preprocess {

void describe(scan_cell_common::ParameterTable& table, TargetFrame& target) {
  table.add("target_frame", target.frame,
            "clouds in another frame are brought into this one by tf, at their stamp, before the "
            "stage; empty: each "
            "cloud stays in its frame");
  table.add("transform_timeout", target.timeout, {0, 60, "s"},
            "how long to wait for that transform");
}

void StageNodelet::start() {
  stage_ = make_stage(getPrivateNodeHandle(), target_);
  if (!target_.frame.empty())
    listener_ = std::make_unique<tf2_ros::TransformListener>(transforms_, getNodeHandle());
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
    const scan_cell_common::CloudView fields = scan_cell_common::view_of(*message);
    Cloud places = scan_cell_common::places_of(fields);
    const Eigen::Isometry3f motion = to_target_frame(message->header);
    if (motion.matrix() != Eigen::Matrix4f::Identity())
      pcl::transformPointCloud(places, places, motion.matrix());
    TracedCloud cloud(std::move(places));
    if (!target_.frame.empty()) result.header.frame_id = target_.frame;
    StageReport report;
    stage_->run(cloud, report);
    result.ok = true;
    result.points_out = report.points_out;
    result.message = report.message;
    output_.publish(boost::make_shared<sensor_msgs::PointCloud2>(scan_cell_common::to_message(
        scan_cell_common::with_fields(cloud.cloud(), fields, cloud.sources(), motion),
        result.header)));
  } catch (const scan_cell_common::Error& error) {
    result.message = error.what();
    NODELET_ERROR("%s", error.what());
  }
  report_.publish(result);
}

Eigen::Isometry3f StageNodelet::to_target_frame(const std_msgs::Header& header) const {
  if (target_.frame.empty() || header.frame_id == target_.frame)
    return Eigen::Isometry3f::Identity();
  try {
    const geometry_msgs::TransformStamped transform = transforms_.lookupTransform(
        target_.frame, header.frame_id, header.stamp, ros::Duration(target_.timeout));
    return scan_cell_common::from_ros(transform.transform).cast<float>();
  } catch (const tf2::TransformException& error) {
    throw scan_cell_common::Refused(
        fmt::format("cloud in frame '{}'", header.frame_id),
        fmt::format("no transform to '{}' within {} s ({})", target_.frame, target_.timeout,
                    error.what()),
        "publish it on /tf or /tf_static, or set target_frame to the cloud's own frame");
  }
}

}  // namespace cloud_preprocess
