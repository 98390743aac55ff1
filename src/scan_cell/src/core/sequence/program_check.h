// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell/scan_run.h"
#include "sequence/devices.h"

namespace scan_cell {

/// Asks the robot whether it could carry out all motions of a program from where it stands: the
/// ways to the starts and the runs. Nothing moves.
/// @param approach_speed [m/s] to the starts
/// @return for a person: what could not be checked
/// @throw scan_cell_common::Refused naming the pass, and the place in it
/// @throw scan_cell_common::Error where the robot does not answer
std::vector<std::string> check_reach(Robot& robot, const std::vector<ScanRun>& runs,
                                     double approach_speed);

}  // namespace scan_cell
