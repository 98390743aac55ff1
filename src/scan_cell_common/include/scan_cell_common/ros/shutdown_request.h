// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// How the signals that ask a process to end (ending_signals()) end one that is a ROS node.
namespace scan_cell_common {

/// From here on all of them end it as Ctrl-C does: ROS shuts down, and the nodes are destroyed.
/// roscpp itself leaves SIGTERM to kill the process on the spot. Handlers that are there stay.
/// node_main() and the suite's nodelets call it.
void shut_down_on_signals();

/// From here on all of them, rosnode kill or a second node of this name only make a request: for
/// nodes that must make safe what they have under way while ROS is still there. To be called after
/// ros::init().
void take_over_shutdown();

bool shutdown_requested();

}  // namespace scan_cell_common
