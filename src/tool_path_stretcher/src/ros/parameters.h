// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include "tool_path_stretcher/stretcher.h"

namespace tool_path_stretcher {

/// Reads the node's parameters.
/// @throw scan_cell_common::InvalidParameter naming the bad one
StretchParameters load_parameters(const ros::NodeHandle& private_node);

}  // namespace tool_path_stretcher
