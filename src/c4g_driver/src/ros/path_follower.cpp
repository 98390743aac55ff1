// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_follower.h"

#include "messages.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"
#include "watcher.h"

namespace c4g_driver {

using scan_cell_common::ConnectionError;
using scan_cell_common::Error;
using scan_cell_msgs::FollowGoal;
using scan_cell_msgs::FollowResult;

PathFollower::PathFollower(ros::NodeHandle node, Client& client,
                           const scan_cell_common::Listeners& listeners, const std::string& status,
                           const std::string& base_frame, double feedback_rate)
    : client_(client),
      listeners_(listeners),
      status_(status),
      base_frame_(base_frame),
      feedback_rate_(feedback_rate),
      server_(
          node, "follow", [this](const auto& goal) { follow(goal); }, false) {}

void PathFollower::follow(const scan_cell_msgs::FollowGoalConstPtr& goal) {
  if (server_.isPreemptRequested()) {
    finish(FollowResult::NOT_BEGUN, "cancelled before it began");
    return;
  }
  try {
    begin(*goal);
  } catch (const ConnectionError& error) {
    finish(FollowResult::LINK_LOST, error.what());
    return;
  } catch (const Error& error) {
    finish(server_.isPreemptRequested() ? FollowResult::NOT_BEGUN : FollowResult::REFUSED,
           error.what());
    return;
  }
  finish(watch(*goal));
}

void PathFollower::begin(const FollowGoal& goal) {
  require_watcher(goal.watcher, listeners_, status_);
  const ToolMotion motion = to_tool_motion(goal, base_frame_);
  flange_to_tip_ = motion.flange_to_tip;
  client_.follow(motion, goal.from_waypoint, [this, &goal] {
    return why_to_stop(server_.isPreemptRequested(), goal.watcher, listeners_).empty();
  });
}

Goal PathFollower::watch(const FollowGoal& goal) {
  bool stopping = false;
  while (true) {
    const Goal now = client_.wait_for_goal(1 / feedback_rate_);
    if (!now.underway()) return now;
    publish_feedback(now);
    const std::string reason =
        stopping ? "" : why_to_stop(server_.isPreemptRequested(), goal.watcher, listeners_);
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

geometry_msgs::PoseStamped PathFollower::tip(const MeasuredState& state) const {
  geometry_msgs::PoseStamped pose = to_pose(state, base_frame_);
  pose.pose = scan_cell_common::to_ros_pose(state.robot.flange * flange_to_tip_);
  return pose;
}

void PathFollower::publish_feedback(const Goal& goal) {
  const auto state = client_.latest();
  if (!state) return;
  scan_cell_msgs::FollowFeedback feedback;
  feedback.waypoint = static_cast<std::uint32_t>(goal.waypoint());
  feedback.progress = goal.progress();
  feedback.tip = tip(*state);
  feedback.outputs = state->robot.outputs;
  server_.publishFeedback(feedback);
}

void PathFollower::finish(const Goal& end) {
  const auto outcome = [&] {
    switch (end.outcome()) {
      case Goal::Outcome::kReached:
        return FollowResult::REACHED;
      case Goal::Outcome::kStopped:
        return FollowResult::STOPPED;
      case Goal::Outcome::kLinkLost:
        return FollowResult::LINK_LOST;
      case Goal::Outcome::kFailed:
      case Goal::Outcome::kNone:
      case Goal::Outcome::kUnderway:
        break;
    }
    return FollowResult::CONTROLLER_ERROR;
  };
  finish(outcome(), end.message(), end.waypoint());
}

void PathFollower::finish(std::uint8_t outcome, const std::string& message,
                          std::uint64_t waypoint) {
  FollowResult result;
  result.outcome = outcome;
  result.message = message;
  result.waypoint = static_cast<std::uint32_t>(waypoint);
  const auto state = client_.latest();
  if (state) result.tip = tip(*state);
  if (outcome == FollowResult::REACHED) {
    server_.setSucceeded(result, message);
  } else if (server_.isPreemptRequested() &&
             (outcome == FollowResult::STOPPED || outcome == FollowResult::NOT_BEGUN)) {
    server_.setPreempted(result, message);
  } else {
    server_.setAborted(result, message);
  }
}

}  // namespace c4g_driver
