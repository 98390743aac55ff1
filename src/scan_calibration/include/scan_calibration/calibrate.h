// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_calibration/calibration.h"

namespace scan_calibration {

/// @param lasers of the session
/// @throw scan_cell_common::InvalidParameter naming an option that makes no sense
void check(const CalibrationOptions& options, const std::vector<std::string>& lasers);

/// Camera, its pose on the flange, board and every laser plane in one robust least-squares
/// estimate, from a closed-form start. Without lasers in the session the camera alone; with
/// `lasers_alone` the planes and the board, the camera as it is.
/// @throw scan_cell_common::InvalidParameter as check()
/// @throw scan_cell_common::UnusableInput saying what the session lacks or what is wrong with it:
/// too few views, views too alike, a laser never seen, a wrong board size, poses and images out of
/// step, angles in the wrong unit, an existing camera that the views do not fit
Calibration calibrate(const Observations& observations, const CalibrationOptions& options);

}  // namespace scan_calibration
