// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

namespace scan_cell {

/// Lets this node watch over goals of the cell, by subscribing to the cell's state. A goal whose
/// field `watcher` names this node is cancelled if this process dies, even by SIGKILL: the kernel
/// closes its connection.
class CellWatcher {
 public:
  /// @param state topic of the cell
  CellWatcher(ros::NodeHandle node, const std::string& state);

  /// Waits until the cell is connected.
  /// @param timeout [s]
  /// @return this node's name, for a goal's field `watcher`
  /// @throw scan_cell_common::ConnectionError if it is not connected within that time
  std::string name(double timeout) const;

 private:
  ros::Subscriber state_;
};

}  // namespace scan_cell
