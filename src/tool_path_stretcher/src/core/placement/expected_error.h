// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "placement/placement.h"
#include "uncertainty/mapping_error.h"

namespace tool_path_stretcher {

/// Fills in the expected errors of each waypoint.
/// @param path the path on the reference from which the placement was made
void expect_errors(const ToolPath& path, const MappingError& mapping_error, Placement& placement);

}  // namespace tool_path_stretcher
