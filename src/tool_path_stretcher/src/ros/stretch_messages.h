// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/StretchToolPathGoal.h>
#include <scan_cell_msgs/StretchToolPathResult.h>

#include "report.h"

namespace tool_path_stretcher {

/// The node's parameters, overridden by those in the goal.
/// @throw scan_cell_common::InvalidParameter naming the value that makes no sense
StretchParameters with_goal(const StretchParameters& parameters,
                            const scan_cell_msgs::StretchToolPathGoal& goal);

/// @param header of the object's cloud
scan_cell_msgs::StretchToolPathResult to_message(const StretchResult& result,
                                                 const std_msgs::Header& header,
                                                 const RunRecord& record = {});

}  // namespace tool_path_stretcher
