// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/node_handle.h>

#include <mutex>
#include <set>
#include <string>

namespace scan_cell {

/// The goals in progress on an action's server, whoever sent them. Callbacks must be served by
/// another thread.
class GoalsUnderWay {
 public:
  GoalsUnderWay(ros::NodeHandle node, const std::string& action);

  /// Cancels all of them.
  /// @param timeout [s] for the server to be there
  /// @throw scan_cell_common::ConnectionError if it is not: the goals are unknown
  void cancel(double timeout);

  /// Waits until the cancelled goals have ended. If the server is gone, they have.
  /// @param timeout [s]
  /// @throw scan_cell_common::ConnectionError if they have not within that time
  void wait_until_ended(double timeout) const;

 private:
  void on_status(const actionlib_msgs::GoalStatusArray& status);

  const std::string action_;
  mutable std::mutex mutex_;  // guards all that follows
  std::set<std::string> under_way_;
  std::uint64_t heard_ = 0;      // messages
  std::uint64_t cancelled_ = 0;  // count when cancel() was called
  ros::Publisher canceller_;
  ros::Subscriber status_;  // last, since its callbacks use the other members
};

}  // namespace scan_cell
