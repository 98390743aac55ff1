// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// For nodes that must make safe what they have under way while ROS is still there.
namespace scan_cell_common {

/// From here on Ctrl-C, SIGTERM, rosnode kill or a second node of this name only make a request.
/// To be called after ros::init().
void take_over_shutdown();

bool shutdown_requested();

}  // namespace scan_cell_common
