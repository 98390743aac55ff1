// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/ros.h>

#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "link/node_names.h"

namespace scan_cell_rviz {

/// The actions of the recipes' node and of the cell, whoever started them: whether a goal is
/// active, and cancelling it. Safe for use from several threads.
class CellActions {
 public:
  /// @param changed called without a lock when any() may have changed
  CellActions(ros::NodeHandle node, const NodeNames& names, std::function<void()> changed);

  bool any() const;  ///< whether a goal is active

  /// Cancels what is active in the cell. The recipes' node cancels its own goals there, so it knows
  /// why they ended; if it does not within a second, look() does. Goals have timestamps of other
  /// computers' clocks, so all are cancelled, even a new one.
  /// @param by_recipes the recipes' node is known to have a goal
  void stop(bool by_recipes);
  void look();  ///< call it several times a second

  /// Their node is gone, and its goals with it.
  void forget_recipes();
  void forget_cell();
  void forget();  ///< both, until they publish again

  const ros::Subscriber& of_recipes() const { return actions_.at(recipes_).status; }

 private:
  struct Action {
    ros::Subscriber status;
    ros::Publisher cancel;
    bool under_way = false;
  };

  void follow(ros::NodeHandle& node, const std::string& action);
  void set(const std::string& action, bool under_way);
  void stop_cell();

  const std::string recipes_, cell_;  // action of the recipes' node, name of the cell's node
  const std::function<void()> changed_;
  std::map<std::string, Action> actions_;  // by name
  ros::WallTime stopped_;                  // time of stop(); zero: none pending
  mutable std::mutex mutex_;               // guards under_way and stopped_
};

}  // namespace scan_cell_rviz
