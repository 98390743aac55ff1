// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// How the signals that ask a process to end (ending_signals()) end one that is a ROS node.
namespace scan_cell_common {

/// What every process with nodes or nodelets of the suite does once ROS has started (node_main()
/// and Nodelet see to it):
///
/// From here on these signals end it as Ctrl-C does: ROS shuts down, and the nodes are destroyed.
/// roscpp itself leaves SIGTERM to kill the process on the spot. Handlers that are there stay.
///
/// The service ~get_loggers, which roscpp gives every process, is withdrawn. In Debian 12
/// (rosconsole 1.14.3 with log4cxx 1.0) answering it destroys the list of loggers, and the process
/// crashes at one of its next log lines. ~set_logger_level does no harm and stays.
void set_up_process();

/// From here on all of them, rosnode kill or a second node of this name only make a request: for
/// nodes that must make safe what they have under way while ROS is still there. To be called after
/// ros::init().
void take_over_shutdown();

bool shutdown_requested();

}  // namespace scan_cell_common
