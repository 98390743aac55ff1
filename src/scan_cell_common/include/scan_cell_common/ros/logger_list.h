// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace scan_cell_common {

/// Takes back the service ~get_loggers that roscpp gives every process, a nodelet manager too. In
/// Debian 12 (rosconsole 1.14.3 with log4cxx 1.0) answering it destroys the list of loggers, and
/// the process crashes at one of its next log lines. ~set_logger_level does no harm and stays.
/// To be called when ROS has started.
void withdraw_logger_list();

}  // namespace scan_cell_common
