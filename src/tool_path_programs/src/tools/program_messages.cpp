// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "program_messages.h"

#include <algorithm>

#include "scan_cell_common/ros/conversions.h"

namespace tool_path_programs {

std::vector<double> times_of(const Program& program, double rotational_speed) {
  std::vector<double> times;
  const Move* before = nullptr;
  for (const Move* move : moves_of(program)) {
    double time = 0;
    if (before != nullptr) {
      const Eigen::Isometry3d step = before->pose.inverse() * move->pose;
      time = times.back() + std::max(step.translation().norm() / move->speed,
                                     Eigen::AngleAxisd(step.linear()).angle() / rotational_speed);
    }
    times.push_back(time);
    before = move;
  }
  return times;
}

nav_msgs::Path path_message(const Program& program, const std::string& frame,
                            const std::vector<double>& times) {
  nav_msgs::Path message;
  message.header.frame_id = frame;
  const auto moves = moves_of(program);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = frame;
    pose.header.stamp = ros::Time(times[i]);
    pose.pose = scan_cell_common::to_ros_pose(moves[i]->pose);
    message.poses.push_back(pose);
  }
  return message;
}

trajectory_msgs::JointTrajectory trajectory_message(const Program& program,
                                                    const std::array<std::string, 6>& names,
                                                    const std::vector<double>& times) {
  trajectory_msgs::JointTrajectory message;
  message.joint_names.assign(names.begin(), names.end());
  const auto moves = moves_of(program);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    trajectory_msgs::JointTrajectoryPoint point;
    point.positions.assign(moves[i]->joints->begin(), moves[i]->joints->end());
    point.time_from_start = ros::Duration(times[i]);
    message.points.push_back(point);
  }
  return message;
}

}  // namespace tool_path_programs
