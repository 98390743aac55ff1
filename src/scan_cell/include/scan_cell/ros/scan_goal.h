// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/ScanAction.h>

#include <string>

#include "scan_cell/scan_program.h"

namespace scan_cell {

/// The goal of the scan action for a program, without a watcher.
scan_cell_msgs::ScanGoal scan_goal(const ScanProgram& program, const std::string& scan_id);

/// The reverse: the pass of a goal, with its poses unchanged.
/// @param name of the pass, for errors
/// @throw scan_cell_common::Refused if its kind or lasers are unknown, or an orientation is invalid
ScanPass pass_from(const scan_cell_msgs::ScanPass& message, const std::string& name);

}  // namespace scan_cell
