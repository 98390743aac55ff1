// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "link/cell_actions.h"

#include <actionlib_msgs/GoalID.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "scan_cell_common/ros/goal_status.h"

namespace scan_cell_rviz {
namespace {

constexpr const char* const kOfCell[] = {"/scan", "/work", "/calibrate"};
constexpr double kPatience = 1;  // [s] for the recipes' node to stop the cell; chosen

}  // namespace

CellActions::CellActions(ros::NodeHandle node, const NodeNames& names,
                         std::function<void()> changed)
    : recipes_(names.recipes + "/run"), cell_(names.cell), changed_(std::move(changed)) {
  for (const char* const action : kOfCell)
    actions_[cell_ + action];
  actions_[recipes_];
  for (const auto& [name, action] : actions_)  // all exist before the first status comes
    follow(node, name);
}

void CellActions::follow(ros::NodeHandle& node, const std::string& action) {
  Action& followed = actions_.at(action);
  followed.cancel = node.advertise<actionlib_msgs::GoalID>(action + "/cancel", 1);
  followed.status = node.subscribe<actionlib_msgs::GoalStatusArray>(
      action + "/status", 10, [this, action](const auto& status) {
        const auto& goals = status->status_list;
        set(action, std::any_of(goals.begin(), goals.end(), scan_cell_common::is_under_way));
      });
}

void CellActions::set(const std::string& action, bool under_way) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (std::exchange(actions_.at(action).under_way, under_way) == under_way) return;
  }
  changed_();
}

bool CellActions::any() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::any_of(actions_.begin(), actions_.end(),
                     [](const auto& action) { return action.second.under_way; });
}

void CellActions::stop(bool by_recipes) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopped_ = ros::WallTime::now();
    if (by_recipes || actions_.at(recipes_).under_way) return;
  }
  stop_cell();
}

void CellActions::look() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stopped_.isZero() || (ros::WallTime::now() - stopped_).toSec() < kPatience) return;
    stopped_ = ros::WallTime();
    const bool goes_on =
        std::any_of(std::begin(kOfCell), std::end(kOfCell),
                    [this](const char* action) { return actions_.at(cell_ + action).under_way; });
    if (!goes_on) return;
  }
  stop_cell();
}

void CellActions::stop_cell() {
  for (const char* const action : kOfCell)
    actions_.at(cell_ + action).cancel.publish(actionlib_msgs::GoalID());
}

void CellActions::forget_recipes() {
  set(recipes_, false);
}

void CellActions::forget_cell() {
  for (const char* const action : kOfCell)
    set(cell_ + action, false);
}

void CellActions::forget() {
  forget_recipes();
  forget_cell();
}

}  // namespace scan_cell_rviz
