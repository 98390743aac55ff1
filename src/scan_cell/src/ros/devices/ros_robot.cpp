// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <ros/this_node.h>
#include <scan_cell_msgs/CheckMotions.h>
#include <scan_cell_msgs/GetStaticPose.h>
#include <scan_cell_msgs/SetControllerParameter.h>
#include <scan_cell_msgs/SetLinearSpeed.h>

#include <algorithm>
#include <cmath>

#include "devices/driver_call.h"
#include "devices/motion_of.h"
#include "devices/ros_devices.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/ros/conversions.h"

namespace scan_cell {

using scan_cell_msgs::MoveGoal;

namespace {

constexpr double kCheckOfAMotion = 0.05;  // [s] many times what the check of a motion takes; chosen

}  // namespace

RosRobot::RosRobot(ros::NodeHandle node, const Parameters& parameters)
    : parameters_(parameters),
      move_client_(node, parameters.robot + "/move"),
      follow_client_(node, parameters.robot + "/follow") {
  status_subscriber_ = node.subscribe(parameters.robot + "/status", 10, &RosRobot::on_status, this);
  transform_subscriber_ = node.subscribe("/tf", 100, &RosRobot::on_transforms, this,
                                         ros::TransportHints().tcpNoDelay());
}

void RosRobot::on_status(const scan_cell_msgs::RobotStatus& status) {
  status_.now();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (status.header.stamp != last_status_.header.stamp) pose_.now();
  last_status_ = status;
}

void RosRobot::on_transforms(const tf2_msgs::TFMessage& transforms) {
  for (const auto& transform : transforms.transforms) {
    if (transform.child_frame_id == parameters_.flange_frame) transform_.now();
  }
}

std::string RosRobot::unseen() const {
  if (!transform_.ever()) {
    return "robot: no pose yet of " + parameters_.flange_frame +
           "; set flange_frame to that of the driver";
  }
  const double age = transform_.age();
  if (age <= parameters_.unseen_after) return "";
  return fmt::format(
      "robot: no pose for {:g} s during a motion; check the controller, its cable and its driver",
      age);
}

std::string RosRobot::trouble() const {
  if (!move_client_.is_connected()) {
    return "robot: no action server " + parameters_.robot + "/move; is its driver running?";
  }
  if (!status_.ever() || status_.age() > parameters_.lost_after) {
    return "robot: no status on " + parameters_.robot + "/status; is its driver running?";
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!last_status_.connected) {
    return "robot: the driver has no connection to the controller (" + last_status_.message +
           "); check the controller and the cable";
  }
  if (pose_.age() > parameters_.lost_after) {
    return fmt::format(
        "robot: no new pose for {:g} s; check the controller's program and the driver's "
        "diagnostics",
        parameters_.lost_after);
  }
  return "";
}

void RosRobot::set_linear_motion(double speed) {
  scan_cell_msgs::SetLinearSpeed::Request linear_speed;
  linear_speed.speed = speed;
  call_driver<scan_cell_msgs::SetLinearSpeed>(parameters_.robot + "/set_linear_speed", linear_speed,
                                              parameters_.call_timeout);
  for (const char* name : {"motion_type", "interpolation"}) {
    scan_cell_msgs::SetControllerParameter::Request parameter;
    parameter.name = name;
    parameter.value = "\"linear\"";
    call_driver<scan_cell_msgs::SetControllerParameter>(parameters_.robot + "/set_parameter",
                                                        parameter, parameters_.call_timeout);
  }
}

MoveGoal RosRobot::goal_of(const MoveTarget& target, double camera_rate) const {
  MoveGoal goal;
  goal.kind = target.via ? MoveGoal::CIRCULAR : MoveGoal::CARTESIAN;
  goal.pose.header.frame_id = parameters_.base_frame;
  goal.pose.header.stamp = ros::Time::now();
  goal.pose.pose = scan_cell_common::to_ros_pose(target.flange);
  goal.via.header = goal.pose.header;
  goal.via.pose = scan_cell_common::to_ros_pose(target.via.value_or(target.flange));
  goal.camera_rate = camera_rate;
  goal.watcher = ros::this_node::getName();
  return goal;
}

std::optional<MovesCheck> RosRobot::check(const std::vector<PlannedMove>& moves) {
  const std::string service = parameters_.robot + "/check_motions";
  if (!ros::service::exists(service, false)) return std::nullopt;
  scan_cell_msgs::CheckMotions::Request request;
  request.linear = 1;
  for (const PlannedMove& move : moves) {
    request.motions.push_back(goal_of(move.target, move.camera_rate));
    request.speeds.push_back(move.speed);
  }
  const double timeout = parameters_.call_timeout + kCheckOfAMotion * double(moves.size());
  const auto answer = call_driver<scan_cell_msgs::CheckMotions>(service, request, timeout);
  MovesCheck check{std::min<std::size_t>(answer.possible, moves.size()), answer.message, {}};
  if (std::isfinite(answer.way))
    check.place = scan_cell_common::from_ros(answer.pose.pose).translation();
  return check;
}

void RosRobot::start_move(const MoveTarget& target, double camera_rate) {
  send(goal_of(target, camera_rate));
}

void RosRobot::send(const MoveGoal& goal) {
  const std::uint64_t move = begin_motion();
  move_client_.send(
      goal, [this, move](const auto& end) { end_motion(move, end.state, motion_of(end.result)); },
      [this, move](const auto& feedback) { on_feedback(move, feedback.progress, 0); });
}

std::uint64_t RosRobot::begin_motion() {
  const std::lock_guard<std::mutex> lock(mutex_);
  motion_ = Motion();
  passed_ = 0;
  return ++move_;
}

void RosRobot::on_feedback(std::uint64_t move, double progress, std::size_t passed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (move != move_ || motion_.state != Motion::State::kMoving) return;
  motion_.progress = progress;
  passed_ = passed;
}

/// @param told what the driver says about a motion that did not reach its target
void RosRobot::end_motion(std::uint64_t move, const actionlib::TerminalState& state,
                          const Motion& told) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (move != move_) return;
  if (state == actionlib::TerminalState::SUCCEEDED) {
    motion_ = {Motion::State::kReached, 1, ""};
    return;
  }
  motion_.state = told.state;
  motion_.message = told.message.empty() ? state.getText() : told.message;
}

Motion RosRobot::motion() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return motion_;
}

std::string RosRobot::hindrance() const {
  using scan_cell_msgs::RobotStatus;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (last_status_.e_stopped == RobotStatus::YES) return "the emergency stop is pressed";
  if (!last_status_.alarm_texts.empty()) return "alarm: " + last_status_.alarm_texts.front();
  if (last_status_.drives_powered == RobotStatus::NO) return "the drives are off";
  if (last_status_.motion_possible == RobotStatus::NO) {
    return "the controller accepts no motion in mode " + last_status_.controller_mode;
  }
  return "";
}

Eigen::Isometry3d RosRobot::static_pose() {
  const auto answer = call_driver<scan_cell_msgs::GetStaticPose>(
      parameters_.robot + "/get_static_pose", {}, parameters_.call_timeout);
  if (answer.pose.header.frame_id != parameters_.base_frame) {
    throw scan_cell_common::Refused("static pose", "in frame '" + answer.pose.header.frame_id + "'",
                                    "set base_frame to the driver's");
  }
  return scan_cell_common::from_ros(answer.pose.pose);
}

bool RosRobot::drop_earlier_goals() {
  if (!move_client_.is_connected()) return false;
  move_client_.cancel_until(made_);
  if (follow_client_.is_connected()) follow_client_.cancel_until(made_);
  return true;
}

void RosRobot::stop() noexcept {
  // Cancels by goal number, in case the clock was set meanwhile, and also any earlier goals.
  move_client_.cancel();
  follow_client_.cancel();
  move_client_.cancel_until(ros::Time::now());
  follow_client_.cancel_until(ros::Time::now());
}

}  // namespace scan_cell
