// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatus.h>

namespace scan_cell_common {

/// Whether an action's server is still dealing with the goal.
inline bool is_under_way(const actionlib_msgs::GoalStatus& goal) {
  using Status = actionlib_msgs::GoalStatus;
  return goal.status == Status::PENDING || goal.status == Status::ACTIVE ||
         goal.status == Status::PREEMPTING || goal.status == Status::RECALLING;
}

}  // namespace scan_cell_common
