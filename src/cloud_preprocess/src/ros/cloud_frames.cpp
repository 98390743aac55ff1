// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_frames.h"

#include <fmt/format.h>
#include <pcl/common/transforms.h>
#include <scan_cell_common/errors/errors.h>
#include <scan_cell_common/ros/cloud_messages.h>
#include <scan_cell_common/ros/conversions.h>

#include <utility>

namespace cloud_preprocess {

void describe(scan_cell_common::ParameterTable& table, TargetFrame& target) {
  table.add("target_frame", target.frame,
            "clouds in another frame are transformed into this one by tf at their stamp before the "
            "stage; empty: each cloud stays in its frame");
  table.add("transform_timeout", target.timeout, {0, 60, "s"},
            "how long to wait for that transform");
}

void CloudFrames::set_target(const TargetFrame& target, const ros::NodeHandle& node) {
  target_ = target;
  if (target_.frame.empty()) {
    listener_.reset();
  } else if (!listener_) {
    listener_ = std::make_unique<tf2_ros::TransformListener>(transforms_, node);
  }
}

std_msgs::Header CloudFrames::header_of(const std_msgs::Header& header) const {
  std_msgs::Header result = header;
  if (!target_.frame.empty()) result.frame_id = target_.frame;
  return result;
}

TracedCloud CloudFrames::places_of(const sensor_msgs::PointCloud2& message,
                                   Eigen::Isometry3f& motion) const {
  Cloud places = scan_cell_common::places_of(scan_cell_common::view_of(message));
  motion = motion_of(message.header);
  if (motion.matrix() != Eigen::Matrix4f::Identity())
    pcl::transformPointCloud(places, places, motion.matrix());
  return TracedCloud(std::move(places));
}

Eigen::Isometry3f CloudFrames::motion_of(const std_msgs::Header& header) const {
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

sensor_msgs::PointCloud2Ptr to_message(const TracedCloud& cloud,
                                       const sensor_msgs::PointCloud2& source,
                                       const Eigen::Isometry3f& motion,
                                       const std_msgs::Header& header) {
  return boost::make_shared<sensor_msgs::PointCloud2>(scan_cell_common::to_message(
      scan_cell_common::with_fields(cloud.cloud(), scan_cell_common::view_of(source),
                                    cloud.sources(), motion),
      header));
}

}  // namespace cloud_preprocess
