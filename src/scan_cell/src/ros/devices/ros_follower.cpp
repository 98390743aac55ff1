// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/this_node.h>
#include <scan_cell_msgs/SetOverride.h>

#include "devices/driver_call.h"
#include "devices/motion_of.h"
#include "devices/ros_devices.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/ros/conversions.h"
#include "tool_path_programs/place_on_path.h"

namespace scan_cell {

using scan_cell_msgs::FollowGoal;

namespace {

constexpr double kCheckOfAWaypoint = 1e-3;  // [s] twice what the check takes
constexpr std::size_t kJoints = 6;

/// Renames places: the driver counts the poses that it was given, a person looks for waypoints of
/// the path.
void name_places(const WorkPlan& plan, scan_cell_msgs::CheckFollow::Response& answer) {
  tool_path_programs::PathWaypoints waypoints;
  for (const WorkWaypoint& pose : plan.waypoints)
    waypoints.push_back(pose.waypoint);
  for (scan_cell_msgs::FollowFault& fault : answer.faults)
    fault.message = tool_path_programs::place_on_path(waypoints, fault.waypoint, fault.way) +
                    (fault.about.empty() ? "" : ", " + fault.about) + ": " + fault.reason;
  if (!answer.faults.empty()) answer.message = answer.faults.front().message;
}

}  // namespace

scan_cell_msgs::FollowWaypoint message_of(const WorkWaypoint& waypoint) {
  scan_cell_msgs::FollowWaypoint message;
  message.tip = scan_cell_common::to_ros_pose(waypoint.tip);
  message.speed = waypoint.speed;
  message.zone = waypoint.zone;
  message.outputs = waypoint.outputs;
  return message;
}

FollowGoal RosRobot::goal_of(const WorkPlan& plan) const {
  FollowGoal goal;
  goal.header.frame_id = parameters_.base_frame;
  goal.header.stamp = ros::Time::now();
  goal.flange_to_tip = scan_cell_common::to_ros_pose(plan.flange_to_tip);
  for (const WorkWaypoint& waypoint : plan.waypoints)
    goal.waypoints.push_back(message_of(waypoint));
  goal.watcher = ros::this_node::getName();
  return goal;
}

scan_cell_msgs::CheckFollow::Response RosRobot::ask_about(const WorkPlan& plan) const {
  const std::string service = parameters_.robot + "/check_follow";
  scan_cell_msgs::CheckFollow::Request request;
  request.path = goal_of(plan);
  const double timeout =
      parameters_.call_timeout + kCheckOfAWaypoint * static_cast<double>(plan.waypoints.size());
  auto answer = call_driver<scan_cell_msgs::CheckFollow>(service, request, timeout);
  name_places(plan, answer);
  return answer;
}

FollowCheck RosRobot::check_follow(const WorkPlan& plan) {
  const auto answer = ask_about(plan);
  FollowCheck check{answer.message, {}};
  if (answer.joints.size() >= kJoints)
    check.start.assign(answer.joints.begin(), answer.joints.begin() + kJoints);
  else if (check.refusal.empty())
    check.refusal = parameters_.robot + "/check_follow gives no joints";
  return check;
}

/// Sets the speed of all motions: the driver's only speed for joints is the controller's override.
void RosRobot::set_joint_speed(double share) {
  double before = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    before = override_before_.value_or(last_status_.override);
  }
  set_override(before * share);
  const std::lock_guard<std::mutex> lock(mutex_);
  override_before_ = before;
}

void RosRobot::restore_speed() noexcept {
  std::optional<double> before;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    before = override_before_;
    override_before_.reset();
  }
  if (!before) return;
  try {
    set_override(*before);
  } catch (const std::exception& error) {
    ROS_WARN("The override stays lowered: %s; set it to %g %%", error.what(), *before);
  }
}

void RosRobot::set_override(double percent) const {
  scan_cell_msgs::SetOverride::Request request;
  request.override = percent;
  const std::string service = parameters_.robot + "/set_override";
  check_answer(service,
               ask<scan_cell_msgs::SetOverride>(service, request, parameters_.call_timeout));
}

void RosRobot::start_joints(const std::vector<double>& joints) {
  scan_cell_msgs::MoveGoal goal;
  goal.kind = scan_cell_msgs::MoveGoal::JOINT;
  goal.joints = joints;
  goal.watcher = ros::this_node::getName();
  send(goal);
}

void RosRobot::start_follow(const WorkPlan& plan) {
  const std::uint64_t move = begin_motion();
  follow_client_.send(
      goal_of(plan),
      [this, move](const auto& end) {
        if (end.result) on_feedback(move, 1, end.result->waypoint);
        end_motion(move, end.state, motion_of(end.result));
      },
      [this, move](const auto& feedback) {
        on_feedback(move, feedback.progress, feedback.waypoint);
      });
}

std::size_t RosRobot::passed() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return passed_;
}

}  // namespace scan_cell
