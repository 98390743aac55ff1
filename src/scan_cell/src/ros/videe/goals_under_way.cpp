// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe/goals_under_way.h"

#include <actionlib_msgs/GoalID.h>

#include <algorithm>
#include <optional>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/goal_status.h"

namespace scan_cell {
namespace {

constexpr double kLook = 0.01;  // [s] between two checks; chosen

}  // namespace

GoalsUnderWay::GoalsUnderWay(ros::NodeHandle node, const std::string& action) : action_(action) {
  canceller_ = node.advertise<actionlib_msgs::GoalID>(action + "/cancel", 10);
  status_ = node.subscribe(action + "/status", 10, &GoalsUnderWay::on_status, this);
}

void GoalsUnderWay::on_status(const actionlib_msgs::GoalStatusArray& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++heard_;
  under_way_.clear();
  for (const auto& goal : status.status_list) {
    if (scan_cell_common::is_under_way(goal)) under_way_.insert(goal.goal_id.id);
  }
}

void GoalsUnderWay::cancel(double timeout) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  while (canceller_.getNumSubscribers() == 0) {
    if (ros::WallTime::now() > deadline) {
      throw scan_cell_common::ConnectionError(action_, "no action server",
                                              "is scan_cell_node running?");
    }
    ros::WallDuration(kLook).sleep();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  cancelled_ = heard_;
  canceller_.publish(actionlib_msgs::GoalID());  // without name and time: all goals
}

void GoalsUnderWay::wait_until_ended(double timeout) const {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  std::optional<std::set<std::string>> cancelled;  // none: nothing received from the server since
  while (canceller_.getNumSubscribers() > 0) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!cancelled && heard_ > cancelled_) cancelled = under_way_;
      if (cancelled && std::none_of(cancelled->begin(), cancelled->end(), [this](const auto& goal) {
            return under_way_.count(goal) > 0;
          })) {
        return;
      }
    }
    if (ros::WallTime::now() > deadline) {
      throw scan_cell_common::ConnectionError(action_, "did not end after it was cancelled",
                                              "look at its log");
    }
    ros::WallDuration(kLook).sleep();
  }
}

}  // namespace scan_cell
