// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_paths/tool_path.h"

namespace tool_path_stretcher {

using tool_paths::Segment;         //!< a run of waypoints with the tool in contact
using tool_paths::ToolPath;        //!< the path to adapt
using tool_paths::Waypoint;        //!< one pose of the tool
using tool_paths::waypoint_count;  //!< of all segments

}  // namespace tool_path_stretcher
