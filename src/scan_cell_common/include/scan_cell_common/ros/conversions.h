// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <ros/time.h>
#include <tf2_eigen/tf2_eigen.h>

#include "scan_cell_common/pose/timed_pose.h"
#include "scan_cell_common/pose/unit_quaternion.h"

namespace scan_cell_common {

inline Nanoseconds from_ros(const ros::Time& time) {
  return static_cast<Nanoseconds>(time.toNSec());
}

inline ros::Time to_ros(Nanoseconds time) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(time));
}

inline Eigen::Quaterniond from_ros(const geometry_msgs::Quaternion& rotation) {
  Eigen::Quaterniond result;
  tf2::fromMsg(rotation, result);
  return result;
}

/// Normalises the quaternion, since messages carry rounded ones; tf2's own conversion of poses does
/// not.
template <class Position>
Eigen::Isometry3d from_ros(const Position& position, const geometry_msgs::Quaternion& rotation) {
  Eigen::Vector3d translation;
  tf2::fromMsg(position, translation);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = from_ros(rotation).normalized().toRotationMatrix();
  result.translation() = translation;
  return result;
}

inline Eigen::Isometry3d from_ros(const geometry_msgs::Pose& pose) {
  return from_ros(pose.position, pose.orientation);
}

inline Eigen::Isometry3d from_ros(const geometry_msgs::Transform& transform) {
  return from_ros(transform.translation, transform.rotation);
}

/// Converts a pose sent by another node.
/// @throw Kind of error about `thing` if its quaternion is not of unit length
template <class Kind = UnusableInput>
Eigen::Isometry3d checked_from_ros(const geometry_msgs::Pose& pose, const std::string& thing,
                                   const std::string& cure = kGiveUnitQuaternion) {
  if (!is_unit(from_ros(pose.orientation)))
    throw Kind(thing, quaternion_fault(from_ros(pose.orientation)), cure);
  return from_ros(pose);
}

/// The quaternion keeps the sign from Eigen, whereas tf2's own conversion of poses makes w >= 0.
inline geometry_msgs::Pose to_ros_pose(const Eigen::Isometry3d& pose) {
  geometry_msgs::Pose result;
  result.position = tf2::toMsg(Eigen::Vector3d(pose.translation()));
  result.orientation = tf2::toMsg(Eigen::Quaterniond(pose.linear()));
  return result;
}

inline geometry_msgs::Transform to_ros_transform(const Eigen::Isometry3d& pose) {
  geometry_msgs::Transform result;
  tf2::toMsg(Eigen::Vector3d(pose.translation()), result.translation);
  result.rotation = tf2::toMsg(Eigen::Quaterniond(pose.linear()));
  return result;
}

}  // namespace scan_cell_common
