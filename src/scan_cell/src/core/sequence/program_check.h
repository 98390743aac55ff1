// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell/scan_run.h"
#include "sequence/devices.h"
#include "sequence/sequence_end.h"

namespace scan_cell {

/// Those that are asked before a program is begun. None of them does anything then.
struct AskedBefore {
  Robot& robot;
  Trigger& trigger;
  Stages& stages;
};

/// Asks binder and triangulation whether they would take all runs of a program, and the robot
/// whether it could carry out all its motions from where it stands: the ways to the starts and the
/// runs. Nothing moves.
/// @param approach_speed [m/s] to the starts
/// @return for a person: what could not be checked
/// @throw EndEarly refused, naming the pass, and the place in it; or that one does not answer
std::vector<std::string> check_runs(const AskedBefore& asked, const std::vector<ScanRun>& runs,
                                    double approach_speed);

/// Asks the trigger whether it would be armed for a run.
/// @param exposure [s] of the camera in it; looked at only where lasers take turns
/// @return for a person: that it could not be checked; empty: it was
/// @throw EndEarly refused, naming the pass; or that the trigger does not answer
std::string check_arming(Trigger& trigger, const ScanRun& run, double exposure);

/// All that can be told of a program while the cell is left as it is: check_runs(), and
/// check_arming() as far as the program tells the exposure.
/// @return for a person: what could not be checked, and what only a scan tries
/// @throw EndEarly as those
std::vector<std::string> check_at_rest(const AskedBefore& asked, const std::vector<ScanRun>& runs,
                                       double approach_speed);

}  // namespace scan_cell
