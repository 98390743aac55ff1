// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/node_handle.h>

#include <mutex>
#include <set>
#include <string>

namespace scan_cell {

/// The goals that an action's server has under way, whoever sent them. Callbacks must be served by
/// another thread.
class GoalsUnderWay {
 public:
  GoalsUnderWay(ros::NodeHandle node, const std::string& action);

  /// Has all of them cancelled.
  /// @param timeout [s] for the server to be there
  /// @throw scan_cell_common::ConnectionError if it is not: nobody knows what is under way
  void cancel(double timeout);

  /// Waits until those that were cancelled have come to their end. Where the server goes they have.
  /// @param timeout [s]
  /// @throw scan_cell_common::ConnectionError if they have not within that time
  void wait_until_ended(double timeout) const;

 private:
  void on_status(const actionlib_msgs::GoalStatusArray& status);

  const std::string action_;
  mutable std::mutex mutex_;  // of what follows
  std::set<std::string> under_way_;
  std::uint64_t heard_ = 0;      // messages
  std::uint64_t cancelled_ = 0;  // of them, when cancel() was called
  ros::Publisher canceller_;
  ros::Subscriber status_;  // last: its callbacks use all the rest
};

}  // namespace scan_cell
