// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <ros/time.h>

#include "scan_cell_common/timed_pose.h"

namespace scan_cell_common {

inline Nanoseconds from_ros(const ros::Time& time) {
  return static_cast<Nanoseconds>(time.toNSec());
}

inline ros::Time to_ros(Nanoseconds time) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(time));
}

/// The quaternion is normalised: messages carry rounded ones.
inline Eigen::Isometry3d from_ros(const geometry_msgs::Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(pose.orientation.w, pose.orientation.x, pose.orientation.y,
                                       pose.orientation.z)
                        .normalized()
                        .toRotationMatrix();
  result.translation() << pose.position.x, pose.position.y, pose.position.z;
  return result;
}

inline Eigen::Isometry3d from_ros(const geometry_msgs::Transform& transform) {
  geometry_msgs::Pose pose;
  pose.position.x = transform.translation.x;
  pose.position.y = transform.translation.y;
  pose.position.z = transform.translation.z;
  pose.orientation = transform.rotation;
  return from_ros(pose);
}

inline geometry_msgs::Pose to_ros_pose(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond rotation(pose.linear());
  geometry_msgs::Pose result;
  result.position.x = pose.translation().x();
  result.position.y = pose.translation().y();
  result.position.z = pose.translation().z();
  result.orientation.x = rotation.x();
  result.orientation.y = rotation.y();
  result.orientation.z = rotation.z();
  result.orientation.w = rotation.w();
  return result;
}

inline geometry_msgs::Transform to_ros_transform(const Eigen::Isometry3d& pose) {
  const geometry_msgs::Pose as_pose = to_ros_pose(pose);
  geometry_msgs::Transform result;
  result.translation.x = as_pose.position.x;
  result.translation.y = as_pose.position.y;
  result.translation.z = as_pose.position.z;
  result.rotation = as_pose.orientation;
  return result;
}

}  // namespace scan_cell_common
