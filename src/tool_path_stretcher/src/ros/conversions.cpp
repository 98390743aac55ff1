// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/ros/conversions.h"

#include <fmt/format.h>
#include <tf2_eigen/tf2_eigen.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::UnusableInput;

Eigen::Isometry3d pose_from(const geometry_msgs::Pose& pose, bool has_orientation,
                            const std::string& name) {
  if (has_orientation) {
    return scan_cell_common::checked_from_ros(pose, name,
                                              "give unit quaternions, or has_orientation = false");
  }
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() << pose.position.x, pose.position.y, pose.position.z;
  return result;
}

geometry_msgs::Pose to_pose(const Eigen::Vector3d& at, const Eigen::Quaterniond& rotation) {
  geometry_msgs::Pose pose;
  pose.position = tf2::toMsg(at);
  pose.orientation = tf2::toMsg(rotation);
  return pose;
}

}  // namespace

ToolPath from_message(const scan_cell_msgs::ToolPath& message) {
  ToolPath path;
  path.name = message.name;
  path.has_orientation = message.has_orientation;
  path.process_names = message.process_names;
  for (const scan_cell_msgs::ToolPathSegment& from : message.segments) {
    Segment segment{from.name, {}};
    for (const scan_cell_msgs::ToolPathWaypoint& waypoint : from.waypoints) {
      const std::string name = fmt::format("tool path '{}', segment {} waypoint {}", path.name,
                                           path.segments.size(), segment.waypoints.size());
      segment.waypoints.push_back(
          {pose_from(waypoint.pose, path.has_orientation, name), waypoint.process_values});
    }
    path.segments.push_back(std::move(segment));
  }
  check(path);
  return path;
}

scan_cell_msgs::ToolPath to_message(const ToolPath& path, const std_msgs::Header& header) {
  scan_cell_msgs::ToolPath message;
  message.header = header;
  message.name = path.name;
  message.has_orientation = path.has_orientation;
  message.process_names = path.process_names;
  for (const Segment& from : path.segments) {
    const std::vector<Eigen::Quaterniond> rotations = continuous_quaternions(from);
    scan_cell_msgs::ToolPathSegment segment;
    segment.name = from.name;
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      scan_cell_msgs::ToolPathWaypoint waypoint;
      waypoint.pose = to_pose(from.waypoints[i].pose.translation(), rotations[i]);
      waypoint.process_values = from.waypoints[i].process_values;
      segment.waypoints.push_back(waypoint);
    }
    message.segments.push_back(segment);
  }
  return message;
}

nav_msgs::Path to_path_message(const ToolPath& path, const std_msgs::Header& header) {
  nav_msgs::Path message;
  message.header = header;
  for (const Segment& segment : path.segments) {
    const std::vector<Eigen::Quaterniond> rotations = continuous_quaternions(segment);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      geometry_msgs::PoseStamped pose;
      pose.header = header;
      pose.pose = to_pose(segment.waypoints[i].pose.translation(), rotations[i]);
      message.poses.push_back(pose);
    }
  }
  return message;
}

}  // namespace tool_path_stretcher
