// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/ros/conversions.h"

#include <cmath>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/ros/conversions.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::UnusableInput;

Eigen::Isometry3d pose_from(const geometry_msgs::Pose& pose, bool has_orientation,
                            const std::string& name) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() << pose.position.x, pose.position.y, pose.position.z;
  if (has_orientation) {
    const Eigen::Quaterniond rotation(pose.orientation.w, pose.orientation.x, pose.orientation.y,
                                      pose.orientation.z);
    constexpr double kUnit = 1e-3;
    if (!(std::abs(rotation.norm() - 1) < kUnit)) {
      throw UnusableInput(name, "a quaternion of length " + std::to_string(rotation.norm()),
                          "give unit quaternions, or has_orientation = false");
    }
    result.linear() = rotation.normalized().toRotationMatrix();
  }
  return result;
}

geometry_msgs::Pose to_pose(const Eigen::Vector3d& at, const Eigen::Quaterniond& rotation) {
  geometry_msgs::Pose pose;
  pose.position.x = at.x();
  pose.position.y = at.y();
  pose.position.z = at.z();
  pose.orientation.x = rotation.x();
  pose.orientation.y = rotation.y();
  pose.orientation.z = rotation.z();
  pose.orientation.w = rotation.w();
  return pose;
}

geometry_msgs::Point to_point(const Eigen::Vector3d& at) {
  geometry_msgs::Point point;
  point.x = at.x();
  point.y = at.y();
  point.z = at.z();
  return point;
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
      const std::string name = "tool path '" + path.name + "', segment " +
                               std::to_string(path.segments.size()) + " waypoint " +
                               std::to_string(segment.waypoints.size());
      segment.waypoints.push_back(
          {pose_from(waypoint.pose, path.has_orientation, name), waypoint.process_values});
    }
    path.segments.push_back(std::move(segment));
  }
  check(path);
  return path;
}

StretchParameters with_goal(const StretchParameters& parameters,
                            const scan_cell_msgs::StretchToolPathGoal& goal) {
  StretchParameters result = parameters;
  if (!goal.method.empty()) result.method = method_from_string(goal.method);
  if (goal.tolerance != 0) result.tolerance = goal.tolerance;
  if (goal.resample_spacing != 0) result.resample_spacing = goal.resample_spacing;
  if (goal.scale != 0 || goal.scale_deviation != 0) {
    result.prior.scale = {goal.scale, goal.scale_deviation};
  }
  if (goal.has_initial_pose) {
    PosePrior pose;
    const geometry_msgs::Vector3& at = goal.initial_pose.translation;
    const geometry_msgs::Quaternion& turn = goal.initial_pose.rotation;
    pose.pose = pose_from_numbers({at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w});
    pose.angle = goal.initial_pose_angle;
    pose.distance = goal.initial_pose_distance;
    result.prior.pose = pose;
  }
  check(result);
  return result;
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

visualization_msgs::MarkerArray correspondence_markers(const ToolPath& from, const ToolPath& to,
                                                       const std_msgs::Header& header) {
  visualization_msgs::Marker lines;
  lines.header = header;
  lines.ns = "correspondences";
  lines.type = visualization_msgs::Marker::LINE_LIST;
  lines.action = visualization_msgs::Marker::ADD;
  lines.pose.orientation.w = 1;
  lines.scale.x = 0.0005;
  lines.color.g = 1;
  lines.color.a = 0.6F;
  for (std::size_t s = 0; s < to.segments.size(); ++s) {
    for (std::size_t w = 0; w < to.segments[s].waypoints.size(); ++w) {
      lines.points.push_back(to_point(from.segments[s].waypoints[w].pose.translation()));
      lines.points.push_back(to_point(to.segments[s].waypoints[w].pose.translation()));
    }
  }
  if (lines.points.empty()) lines.action = visualization_msgs::Marker::DELETEALL;
  visualization_msgs::MarkerArray markers;
  markers.markers.push_back(lines);
  return markers;
}

namespace {

scan_cell_msgs::Similarity to_message(const Similarity& similarity) {
  scan_cell_msgs::Similarity message;
  message.scale = similarity.scale;
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() = similarity.rotation;
  transform.translation() = similarity.translation;
  message.transform = scan_cell_common::to_ros_transform(transform);
  return message;
}

scan_cell_msgs::StretchVerdict to_message(const Verdict& verdict) {
  scan_cell_msgs::StretchVerdict message;
  message.reason = static_cast<std::uint8_t>(verdict.reason);
  message.name = to_string(verdict.reason);
  message.message = verdict.message;
  message.waypoints.assign(verdict.waypoints.begin(), verdict.waypoints.end());
  for (const PoseCandidate& candidate : verdict.candidates) {
    message.candidates.emplace_back();
    message.candidates.back().similarity = to_message(candidate.similarity);
    for (const Eigen::Vector3d& at : candidate.waypoints)
      message.candidates.back().waypoints.push_back(to_point(at));
  }
  return message;
}

scan_cell_msgs::WaypointQuality to_message(const WaypointQuality& quality) {
  scan_cell_msgs::WaypointQuality message;
  message.segment = static_cast<std::uint32_t>(quality.segment);
  message.waypoint = static_cast<std::uint32_t>(quality.waypoint);
  message.measured = quality.measured;
  message.distance_to_scan = quality.distance_to_scan;
  message.support = static_cast<std::uint32_t>(quality.support);
  message.residual = quality.residual;
  message.displacement = quality.displacement;
  message.surface_angle = quality.surface_angle;
  message.gap = quality.gap;
  message.strangers = static_cast<std::uint32_t>(quality.strangers);
  message.expected_error_normal = quality.expected_error_normal;
  message.expected_error_tangential = quality.expected_error_tangential;
  message.expected_error_across = quality.expected_error_across;
  message.least_known.x = quality.least_known.x();
  message.least_known.y = quality.least_known.y();
  message.least_known.z = quality.least_known.z();
  message.position_measured = quality.position_measured;
  return message;
}

}  // namespace

scan_cell_msgs::StretchToolPathResult to_message(const StretchResult& result,
                                                 const std_msgs::Header& header,
                                                 const RunRecord& record) {
  scan_cell_msgs::StretchToolPathResult message;
  message.verdict = to_message(result.verdict);
  message.path = to_message(result.path, header);
  for (const WaypointQuality& quality : result.quality)
    message.quality.push_back(to_message(quality));
  message.similarity = to_message(result.similarity);
  message.rms = result.rms;
  message.inlier_ratio = result.inlier_ratio;
  message.seconds = total_seconds(result, record);
  message.report = report_to_json(result, record);
  return message;
}

}  // namespace tool_path_stretcher
