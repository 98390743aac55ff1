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

/// The actions of the recipes' node and of the cell, whoever asks for them: whether one is under
/// way, and their end. Safe for use from several threads.
class CellActions {
 public:
  /// @param changed any() may be another; called without a lock
  CellActions(ros::NodeHandle node, const NodeNames& names, std::function<void()> changed);

  bool any() const;  ///< has a goal

  /// Ends what is under way in the cell. What the recipes' node began there it ends itself, and
  /// knows then why it ended; where it does not within a second, look() does. Goals have the times
  /// of other computers' clocks, so all are ended, a new one, too.
  /// @param by_recipes it is known to have one
  void stop(bool by_recipes);
  void look();  ///< to be called several times a second

  /// Their node is gone, and with it what it did.
  void forget_recipes();
  void forget_cell();
  void forget();  ///< both, until they tell anew

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

  const std::string recipes_, cell_;  // the action of the one, the node of the other
  const std::function<void()> changed_;
  std::map<std::string, Action> actions_;  // by name
  ros::WallTime stopped_;                  // when stop() was called; zero: long ago
  mutable std::mutex mutex_;               // of under_way and stopped_
};

}  // namespace scan_cell_rviz
