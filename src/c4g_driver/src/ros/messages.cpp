// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"

namespace c4g_driver {
using scan_cell_common::Refused;
using scan_cell_common::to_ros;
using scan_cell_msgs::MoveGoal;
using scan_cell_msgs::RobotStatus;

namespace {

/// Converts a pose that a goal asks for.
/// @param name of the pose
/// @throw Refused for another frame or an invalid quaternion
Eigen::Isometry3d to_target(const geometry_msgs::PoseStamped& pose, const std::string& base_frame,
                            const std::string& name) {
  if (pose.header.frame_id != base_frame) {
    throw Refused(name + " frame", "'" + pose.header.frame_id + "'",
                  "give the flange's pose in " + base_frame);
  }
  return scan_cell_common::checked_from_ros<Refused>(pose.pose, name + " orientation");
}

}  // namespace

tf2_msgs::TFMessage transform_message(const std::string& base_frame,
                                      const std::string& flange_frame) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  message.transforms.front().header.frame_id = base_frame;
  message.transforms.front().child_frame_id = flange_frame;
  return message;
}

sensor_msgs::JointState joint_message(const std::array<std::string, 6>& names) {
  sensor_msgs::JointState message;
  message.name.assign(names.begin(), names.end());
  message.position.resize(names.size());
  return message;
}

void update(geometry_msgs::TransformStamped& message, const MeasuredState& state) {
  message.header.stamp = to_ros(state.time);
  message.transform = scan_cell_common::to_ros_transform(state.robot.flange);
}

void update(sensor_msgs::JointState& message, const MeasuredState& state) {
  message.header.stamp = to_ros(state.time);
  std::copy(state.robot.joints.begin(), state.robot.joints.end(), message.position.begin());
}

geometry_msgs::PoseStamped to_pose(const MeasuredState& state, const std::string& base_frame) {
  geometry_msgs::PoseStamped message;
  message.header.stamp = to_ros(state.time);
  message.header.frame_id = base_frame;
  message.pose = scan_cell_common::to_ros_pose(state.robot.flange);
  return message;
}

RobotStatus to_status(const LinkReport& link, const std::optional<MeasuredState>& state) {
  const auto said = [](bool value) { return value ? RobotStatus::YES : RobotStatus::NO; };
  RobotStatus message;
  message.header.stamp = state ? to_ros(state->time) : ros::Time();
  message.connected = link.up;
  if (!link.up) message.message = link.message;
  message.mode = RobotStatus::MODE_UNKNOWN;
  message.e_stopped = message.drives_powered = message.motion_possible = message.in_motion =
      message.in_error = RobotStatus::UNKNOWN;
  message.override = message.linear_speed = std::nan("");
  if (!link.up || !state) return message;
  const RobotState& robot = state->robot;
  message.mode = robot.mode == ControllerMode::kProgramming ? RobotStatus::MODE_MANUAL
                                                            : RobotStatus::MODE_AUTO;
  message.controller_mode = name_of(robot.mode);
  message.e_stopped = said(robot.e_stop);
  message.drives_powered = said(robot.drives);
  message.motion_possible = said(takes_motions(robot));
  message.in_motion = said(robot.status == MotionStatus::kMoving);
  for (const ControllerError& alarm : robot.alarms) {
    message.alarm_codes.push_back(alarm.code);
    message.alarm_texts.emplace_back(alarm.text.c_str());
  }
  const ControllerError* const first = !robot.alarms.empty() ? &robot.alarms.front()
                                       : robot.error         ? &*robot.error
                                                             : nullptr;
  message.in_error = said(first != nullptr);
  message.error_code = first != nullptr ? first->code : 0;
  message.override = robot.override;
  message.linear_speed = robot.linear_speed;
  if (first != nullptr) message.message = first->text.c_str();
  return message;
}

Motion to_motion(const MoveGoal& goal, const std::string& base_frame) {
  Motion motion;
  motion.camera_rate = goal.camera_rate;
  if (goal.kind == MoveGoal::JOINT) {
    motion.kind = Motion::Kind::kToJoints;
    motion.joints = goal.joints;
    return motion;
  }
  if (goal.kind != MoveGoal::CARTESIAN && goal.kind != MoveGoal::CIRCULAR) {
    throw Refused("kind of motion", fmt::format("{}", goal.kind),
                  "give CARTESIAN, JOINT or CIRCULAR");
  }
  if (goal.kind == MoveGoal::CIRCULAR) {
    motion.kind = Motion::Kind::kAlongArc;
    motion.via = to_target(goal.via, base_frame, "via");
  }
  motion.flange = to_target(goal.pose, base_frame, "target");
  return motion;
}

void fill_in(scan_cell_msgs::CheckMotions::Response& response, const PlanCheck& plan,
             const std::string& base_frame) {
  response.message = plan.refusal;
  response.possible = static_cast<std::uint32_t>(plan.ends.size());
  response.way = std::nan("");
  response.pose.header.frame_id = base_frame;
  if (plan.place) {
    response.way = plan.place->way;
    response.pose.pose = scan_cell_common::to_ros_pose(plan.place->flange);
  }
  if (!plan.ends.empty()) response.joints.assign(plan.ends.back().begin(), plan.ends.back().end());
}

ToolMotion to_tool_motion(const scan_cell_msgs::FollowGoal& goal, const std::string& base_frame) {
  using scan_cell_common::checked_from_ros;
  if (goal.header.frame_id != base_frame)
    throw Refused("frame", "'" + goal.header.frame_id + "'",
                  "give the tip's poses in " + base_frame);
  ToolMotion motion;
  motion.flange_to_tip = checked_from_ros<Refused>(goal.flange_to_tip, "flange_to_tip");
  for (std::size_t i = 0; i < goal.waypoints.size(); ++i) {
    const scan_cell_msgs::FollowWaypoint& waypoint = goal.waypoints[i];
    motion.waypoints.push_back(
        {checked_from_ros<Refused>(waypoint.tip, fmt::format("waypoint {} orientation", i)),
         waypoint.speed, waypoint.zone, waypoint.outputs});
  }
  return motion;
}

void fill_in(scan_cell_msgs::CheckFollow::Response& response, const ToolCheck& check,
             std::size_t from) {
  response.message = check.refusal();
  for (const ToolFault& fault : check.faults) {
    scan_cell_msgs::FollowFault message;
    message.waypoint = static_cast<std::uint32_t>(from + fault.waypoint);
    message.way = fault.way;
    message.tip = scan_cell_common::to_ros_pose(fault.tip);
    message.about = fault.about;
    message.reason = fault.value + "; " + fault.cure;
    message.message = fault.what();
    response.faults.push_back(message);
  }
  for (const Joints& joints : check.joints)
    response.joints.insert(response.joints.end(), joints.begin(), joints.end());
  response.slowest_speed = std::nan("");
  if (!check.slowest) return;
  response.slowest_waypoint = static_cast<std::uint32_t>(from + check.slowest->waypoint);
  response.slowest_speed = check.slowest->speed;
}

}  // namespace c4g_driver
