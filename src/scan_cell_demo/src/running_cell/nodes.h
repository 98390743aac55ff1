// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

namespace scan_cell_demo {

/// Waits for a condition, which is checked every 10 ms.
/// @throw scan_cell_common::Refused after a minute
void wait_until(const std::string& what, const std::function<bool()>& met);

/// Process ID of a ROS node on this machine, as reported by the node.
/// @throw scan_cell_common::ConnectionError if the node does not answer
pid_t checked_process_of(const std::string& node);

/// Waits until roslaunch has restarted a node.
/// @throw scan_cell_common::ConnectionError if it does not come up within `timeout` [s]
void wait_for_successor(const std::string& node, pid_t killed, double timeout);

}  // namespace scan_cell_demo
