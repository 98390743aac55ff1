// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "static_transforms.h"

#include <tf2/exceptions.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"

namespace pose_frame_binder {

StaticTransforms::StaticTransforms(ros::NodeHandle node) {
  constexpr std::uint32_t kMessages = 100;  // each publisher latches one; chosen
  subscriber_ = node.subscribe("/tf_static", kMessages, &StaticTransforms::on_transforms, this);
}

void StaticTransforms::on_transforms(const tf2_msgs::TFMessage& message) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    buffer_.setTransform(transform, "tf_static", true);
  }
}

Eigen::Isometry3d StaticTransforms::look_up(const std::string& parent, const std::string& child,
                                            double timeout) const {
  if (parent == child) return Eigen::Isometry3d::Identity();
  constexpr double kLook = 0.01;  // [s] between two checks; chosen
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  while (!buffer_.canTransform(parent, child, ros::Time(0)) && ros::WallTime::now() < deadline &&
         ros::ok()) {
    ros::WallDuration(kLook).sleep();
  }
  try {
    return scan_cell_common::from_ros(
        buffer_.lookupTransform(parent, child, ros::Time(0)).transform);
  } catch (const tf2::TransformException& error) {
    throw scan_cell_common::Refused(
        "static transform from " + parent + " to " + child, error.what(),
        "publish it on /tf_static; check that the launch file loads the calibration");
  }
}

}  // namespace pose_frame_binder
