// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell/scan_run.h"
#include "sequence/devices.h"
#include "sequence/sequence_end.h"

namespace scan_cell {

/// Devices that are asked before a program begins. None of them does anything then.
struct AskedBefore {
  Robot& robot;
  Trigger& trigger;
  Stages& stages;
};

/// Asks binder and triangulation whether they would accept all runs of a program, and the robot
/// whether it could carry out all its motions from where it stands: the ways to the starts and the
/// runs. Nothing moves.
/// @param approach_speed [m/s] to the starts
/// @return for a person: what could not be checked
/// @throw EndEarly if refused, naming the pass and the place in it; or if one does not answer
std::vector<std::string> check_runs(const AskedBefore& asked, const std::vector<ScanRun>& runs,
                                    double approach_speed);

/// Asks the trigger whether it would be armed for a run.
/// @param exposure [s] of the camera in it; only used if the lasers take turns
/// @return for a person: that it could not be checked; empty: it was checked
/// @throw EndEarly if refused, naming the pass; or if the trigger does not answer
std::string check_arming(Trigger& trigger, const ScanRun& run, double exposure);

/// All checks of a program that leave the cell as it is: check_runs(), and check_arming() for
/// passes whose exposure the program gives.
/// @return for a person: what could not be checked, and what only a scan tries
/// @throw EndEarly as these
std::vector<std::string> check_at_rest(const AskedBefore& asked, const std::vector<ScanRun>& runs,
                                       double approach_speed);

}  // namespace scan_cell
