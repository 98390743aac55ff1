// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_node.h"

#include <fmt/format.h>

#include "messages.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/service_answer.h"
#include "watcher.h"

namespace c4g_driver {

using scan_cell_common::ConnectionError;
using scan_cell_common::Error;
using scan_cell_common::Refused;
using scan_cell_msgs::MoveGoal;
using scan_cell_msgs::MoveResult;

namespace {

/// For answers that distinguish a lost link from a refusal.
template <class Response>
auto say_link_lost(Response& response, int) -> decltype(response.link_lost, void()) {
  response.link_lost = true;
}
template <class Response>
void say_link_lost(Response&, long) {}  // NOLINT: the other overload is preferred

}  // namespace

DriverNode::DriverNode(ros::NodeHandle node, ros::NodeHandle private_node,
                       const DriverParameters& parameters)
    : parameters_(parameters),
      transforms_(node.advertise<tf2_msgs::TFMessage>("/tf", 100)),
      joint_states_(node.advertise<sensor_msgs::JointState>("joint_states", 100)),
      status_(listeners_.advertise<scan_cell_msgs::RobotStatus>(private_node, "status", 10)),
      transform_(transform_message(parameters.base_frame, parameters.flange_frame)),
      joints_(joint_message(parameters.client.robot->joint_names())),
      client_(parameters.client, [this](const MeasuredState& state) { publish(state); }),
      server_(
          private_node, "move", [this](const auto& goal) { move(goal); }, false),
      path_follower_(private_node, client_, listeners_, status_.getTopic(), parameters.base_frame,
                     parameters.feedback_rate),
      jogger_(private_node, client_, parameters.jog_silence, parameters.max_jog_override),
      diagnostics_(node, private_node) {
  diagnostics_.setHardwareID(parameters.client.address);
  diagnostics_.add("link", [this](auto& status) { diagnosis_.report(client_.link(), status); });
  diagnostics_.add("robot", [this](auto& status) {
    report(client_.link().up ? client_.latest() : std::nullopt, status);
  });
  ros::NodeHandle services(private_node);
  services.setCallbackQueue(&service_queue_);
  advertise<scan_cell_msgs::SetOverride>(services, "set_override", &DriverNode::set_override);
  advertise<scan_cell_msgs::SetLinearSpeed>(services, "set_linear_speed",
                                            &DriverNode::set_linear_speed);
  advertise<std_srvs::SetBool>(services, "set_drives", &DriverNode::set_drives);
  advertise<std_srvs::Trigger>(services, "reset_alarms", &DriverNode::reset_alarms);
  advertise<scan_cell_msgs::GetStaticPose>(services, "get_static_pose",
                                           &DriverNode::get_static_pose);
  advertise<scan_cell_msgs::GetControllerParameter>(services, "get_parameter",
                                                    &DriverNode::get_parameter);
  advertise<scan_cell_msgs::SetControllerParameter>(services, "set_parameter",
                                                    &DriverNode::set_parameter);
  advertise<scan_cell_msgs::CheckMotions>(services, "check_motions", &DriverNode::check_motions);
  advertise<scan_cell_msgs::CheckFollow>(services, "check_follow", &DriverNode::check_follow);
  status_timer_ = node.createTimer(ros::Duration(1 / parameters.status_rate),
                                   [this](const ros::TimerEvent&) { publish_status(); });
  server_.start();
  path_follower_.start();
  service_spinner_.start();
}

void DriverNode::publish(const MeasuredState& state) {
  update(transform_.transforms.front(), state);
  update(joints_, state);
  transforms_.publish(transform_);
  joint_states_.publish(joints_);
}

void DriverNode::publish_status() {
  constexpr double kReminder = 10;  // [s] chosen
  LinkReport link = client_.link();
  const bool lost = link.losses > losses_;
  losses_ = link.losses;
  if (lost) {  // reported once, however soon the next session began
    link.up = false;
    ROS_WARN("controller %s: the link was lost: %s", parameters_.client.address.c_str(),
             link.message.c_str());
  }
  status_.publish(to_status(link, client_.latest()));
  if (link.up && !was_up_) ROS_INFO("controller %s: connected", parameters_.client.address.c_str());
  if (!link.up && !lost) {
    ROS_WARN_THROTTLE(kReminder, "controller %s:%d: %s; trying again every %g s",
                      parameters_.client.address.c_str(), parameters_.client.port,
                      link.message.c_str(), parameters_.client.reconnect_period);
  }
  was_up_ = link.up;
  diagnostics_.update();  // publishes once a second, however often it is called
}

void DriverNode::move(const scan_cell_msgs::MoveGoalConstPtr& goal) {
  if (server_.isPreemptRequested()) {
    finish(MoveResult::NOT_BEGUN, "cancelled before it began");
    return;
  }
  try {
    start(*goal);
  } catch (const ConnectionError& error) {
    finish(MoveResult::LINK_LOST, error.what());
    return;
  } catch (const Error& error) {
    finish(MoveResult::REFUSED, error.what());
    return;
  }
  finish(follow(goal->watcher));
}

void DriverNode::start(const MoveGoal& goal) {
  require_watcher(goal.watcher, listeners_, status_.getTopic());
  client_.move(to_motion(goal, parameters_.base_frame));
}

Goal DriverNode::follow(const std::string& watcher) {
  bool stopping = false;
  while (true) {
    const Goal goal = client_.wait_for_goal(1 / parameters_.feedback_rate);
    if (!goal.underway()) return goal;
    const auto state = client_.latest();
    if (state) {
      scan_cell_msgs::MoveFeedback feedback;
      feedback.progress = goal.progress();
      feedback.pose = to_pose(*state, parameters_.base_frame);
      server_.publishFeedback(feedback);
    }
    const std::string reason =
        stopping ? "" : why_to_stop(server_.isPreemptRequested(), watcher, listeners_);
    if (reason.empty()) continue;
    try {
      client_.stop();
      ROS_INFO("the robot was told to stop: %s", reason.c_str());
      stopping = true;
    } catch (const Error& error) {
      ROS_ERROR_THROTTLE(1, "%s", error.what());  // a lost link ends the goal; else tried again
    }
  }
}

void DriverNode::finish(const Goal& end) {
  switch (end.outcome()) {
    case Goal::Outcome::kReached:
      return finish(MoveResult::REACHED, end.message());
    case Goal::Outcome::kStopped:
      return finish(MoveResult::STOPPED, end.message());
    case Goal::Outcome::kLinkLost:
      return finish(MoveResult::LINK_LOST, end.message());
    case Goal::Outcome::kFailed:
    case Goal::Outcome::kNone:
    case Goal::Outcome::kUnderway:
      return finish(MoveResult::CONTROLLER_ERROR, end.message());
  }
}

void DriverNode::finish(std::uint8_t outcome, const std::string& message) {
  MoveResult result;
  result.outcome = outcome;
  result.message = message;
  const auto state = client_.latest();
  if (state) result.pose = to_pose(*state, parameters_.base_frame);
  if (outcome == MoveResult::REACHED) {
    server_.setSucceeded(result, message);
  } else if (server_.isPreemptRequested() &&
             (outcome == MoveResult::STOPPED || outcome == MoveResult::NOT_BEGUN)) {
    server_.setPreempted(result, message);
  } else {
    server_.setAborted(result, message);
  }
}

template <class Service>
void DriverNode::advertise(ros::NodeHandle& node, const std::string& name,
                           void (DriverNode::*handler)(const typename Service::Request&,
                                                       typename Service::Response&)) {
  const boost::function<bool(typename Service::Request&, typename Service::Response&)> serve =
      [this, handler](typename Service::Request& request, typename Service::Response& response) {
        return scan_cell_common::answer(response, [&] {
          try {
            (this->*handler)(request, response);
          } catch (const ConnectionError&) {
            say_link_lost(response, 0);
            throw;
          }
        });
      };
  services_.push_back(node.advertiseService(name, serve));
}

void DriverNode::set_override(const scan_cell_msgs::SetOverride::Request& request,
                              scan_cell_msgs::SetOverride::Response&) {
  client_.set_override(request.override);
}

void DriverNode::set_linear_speed(const scan_cell_msgs::SetLinearSpeed::Request& request,
                                  scan_cell_msgs::SetLinearSpeed::Response&) {
  client_.set_linear_speed(request.speed);
}

void DriverNode::set_drives(const std_srvs::SetBool::Request& request,
                            std_srvs::SetBool::Response&) {
  client_.set_drives(request.data);
}

void DriverNode::reset_alarms(const std_srvs::Trigger::Request&, std_srvs::Trigger::Response&) {
  client_.reset_alarms();
}

void DriverNode::check_motions(const scan_cell_msgs::CheckMotions::Request& request,
                               scan_cell_msgs::CheckMotions::Response& response) {
  if (!request.speeds.empty() && request.speeds.size() != request.motions.size()) {
    throw Refused("speeds",
                  fmt::format("{} of {} motions", request.speeds.size(), request.motions.size()),
                  "give one for each motion, or none");
  }
  std::vector<PlannedMotion> plan;
  for (const MoveGoal& goal : request.motions) {
    plan.push_back({to_motion(goal, parameters_.base_frame), std::nullopt});
    if (!request.speeds.empty()) plan.back().linear_speed = request.speeds[plan.size() - 1];
  }
  fill_in(response, client_.check(plan, request.linear != 0U, request.joints),
          parameters_.base_frame);
}

void DriverNode::check_follow(const scan_cell_msgs::CheckFollow::Request& request,
                              scan_cell_msgs::CheckFollow::Response& response) {
  fill_in(response,
          client_.check(to_tool_motion(request.path, parameters_.base_frame),
                        request.path.from_waypoint, {request.joints.begin(), request.joints.end()}),
          request.path.from_waypoint);
  const auto& names = parameters_.client.robot->joint_names();
  response.joint_names.assign(names.begin(), names.end());
}

void DriverNode::get_static_pose(const scan_cell_msgs::GetStaticPose::Request&,
                                 scan_cell_msgs::GetStaticPose::Response& response) {
  const MeasuredState state = client_.static_pose();
  response.pose = to_pose(state, parameters_.base_frame);
  response.joints = joint_message(parameters_.client.robot->joint_names());
  update(response.joints, state);
}

void DriverNode::get_parameter(const scan_cell_msgs::GetControllerParameter::Request& request,
                               scan_cell_msgs::GetControllerParameter::Response& response) {
  response.value = client_.get_parameter(request.name);
}

void DriverNode::set_parameter(const scan_cell_msgs::SetControllerParameter::Request& request,
                               scan_cell_msgs::SetControllerParameter::Response&) {
  client_.set_parameter(request.name, request.value);
}

}  // namespace c4g_driver
