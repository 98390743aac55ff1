// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "scan_calibration/calibration_run.h"

namespace scan_cell {

/// Markers that show a calibration: in `base_frame`, the board from each view alone (the boards
/// should coincide) with the camera that saw it, and in tool0, each plane of light with the points
/// on it. The first marker removes those of an earlier calibration.
/// @param run must have a calibration
visualization_msgs::MarkerArray calibration_markers(const scan_calibration::CalibrationRun& run,
                                                    const std::string& base_frame);

}  // namespace scan_cell
