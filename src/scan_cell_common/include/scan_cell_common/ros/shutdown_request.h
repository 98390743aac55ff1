// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// How ending signals (ending_signals()) end a process that is a ROS node.
namespace scan_cell_common {

/// Sets up a process with nodes or nodelets of the suite once ROS has started; node_main() and
/// Nodelet call it:
///
/// From here on these signals end it as Ctrl-C does: ROS shuts down, and the nodes are destroyed.
/// With roscpp alone, SIGTERM kills the process on the spot. Existing handlers stay.
///
/// The service ~get_loggers, which roscpp adds to every process, is withdrawn. In Debian 12
/// (rosconsole 1.14.3 with log4cxx 1.0) answering it destroys the list of loggers, and the process
/// crashes at one of its next log lines. ~set_logger_level does no harm and stays.
void set_up_process();

/// From here on these signals, rosnode kill and a second node of the same name only request a
/// shutdown, for nodes that must make their work safe while ROS is still up. Call it after
/// ros::init().
void take_over_shutdown();

bool shutdown_requested();

}  // namespace scan_cell_common
