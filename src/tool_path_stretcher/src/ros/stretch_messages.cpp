// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "stretch_messages.h"

#include <tf2_eigen/tf2_eigen.h>

#include "scan_cell_common/ros/conversions.h"
#include "tool_path_stretcher/ros/conversions.h"

namespace tool_path_stretcher {
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
      message.candidates.back().waypoints.push_back(tf2::toMsg(at));
  }
  return message;
}

scan_cell_msgs::WaypointQuality to_message(const WaypointQuality& quality) {
  scan_cell_msgs::WaypointQuality message;
  message.segment = static_cast<std::uint32_t>(quality.segment);
  message.waypoint = static_cast<std::uint32_t>(quality.waypoint);
  message.measured = quality.measured;
  message.in_air = quality.in_air;
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
  message.expected_error_orientation = quality.expected_error_orientation;
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
