// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pass_planner/tool_path_check.h"

namespace pass_planner {

/// A fault in words, with waypoints counted as in the path.
std::string fault_text(const PathForRobot& path, const c4g_driver::ToolFault& fault);

/// The result of the check, as the JSON text of docs/pass_planner.md.
/// @param approach why the robot cannot move to the start; empty: it can
std::string tool_check_to_json(const PathForRobot& path, const c4g_driver::ToolCheck& check,
                               const std::string& approach);

/// In words: what fails, the slowest place, and the joint that comes nearest to its limit.
std::string summary_of(const PathForRobot& path, const c4g_driver::ToolCheck& check,
                       const std::string& approach);

}  // namespace pass_planner
