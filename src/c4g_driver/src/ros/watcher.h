// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/listeners.h"

namespace c4g_driver {

/// @param watcher node named by a goal; empty: none
/// @param status topic to which it must subscribe
/// @throw scan_cell_common::Refused if it does not
inline void require_watcher(const std::string& watcher,
                            const scan_cell_common::Listeners& listeners,
                            const std::string& status) {
  if (watcher.empty() || listeners.contains(watcher)) return;
  throw scan_cell_common::Refused("watcher",
                                  "'" + watcher + "', which does not listen to the status",
                                  "subscribe to " + status + " first, or give none");
}

/// Why a goal in progress must stop; empty: it need not.
inline std::string why_to_stop(bool preempted, const std::string& watcher,
                               const scan_cell_common::Listeners& listeners) {
  if (ros::isShuttingDown() || !ros::ok()) return "the driver is shutting down";
  if (preempted) return "cancelled";
  if (!watcher.empty() && !listeners.contains(watcher)) return watcher + " is gone";
  return "";
}

}  // namespace c4g_driver
