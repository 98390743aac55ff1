// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "running_cell/nodes.h"

#include <ros/time.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/node_process.h"

namespace scan_cell_demo {

using scan_cell_common::ConnectionError;
using scan_cell_common::process_of;

void wait_until(const std::string& what, const std::function<bool()>& met) {
  constexpr double kPatience = 60, kPeriod = 0.01;  // [s]
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (!met()) {
    if (ros::WallTime::now() > deadline)
      throw scan_cell_common::Refused(what, "not there after a minute",
                                      "see the cell's log; end other simulators and programs");
    ros::WallDuration(kPeriod).sleep();
  }
}

pid_t checked_process_of(const std::string& node) {
  const auto process = process_of(node);
  if (!process) throw ConnectionError(node, "does not answer", "is it running?");
  return *process;
}

void wait_for_successor(const std::string& node, pid_t killed, double timeout) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  while (process_of(node).value_or(killed) == killed) {
    if (ros::WallTime::now() > deadline)
      throw ConnectionError(node, "was not started again", "start the cell with respawn:=true");
    ros::WallDuration(0.05).sleep();
  }
}

}  // namespace scan_cell_demo
