// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

namespace scan_cell {

/// Makes this node one that can watch over goals of the cell: it listens to the cell's state. A
/// goal whose field `watcher` names it is cancelled where this process dies, SIGKILL too: the
/// kernel closes its connection.
class CellWatcher {
 public:
  /// @param state topic of the cell
  CellWatcher(ros::NodeHandle node, const std::string& state);

  /// Waits until the cell is connected.
  /// @param timeout [s]
  /// @return this node's name, for a goal's field `watcher`
  /// @throw scan_cell_common::ConnectionError if it is not within that time
  std::string name(double timeout) const;

 private:
  ros::Subscriber state_;
};

}  // namespace scan_cell
