// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scan_cell/scan_request.h"

namespace pass_planner {

/// One polyline through lines, each starting from the end that is nearer to the line before.
/// Between lines the flange moves straight, and the camera is still pulsed.
/// @param lines at least one; if their lasers differ, the polyline has both in turns
/// @param rate [Hz] frames a laser
scan_cell::ScanPass joined(std::vector<scan_cell::ScanPass> lines, double rate);

}  // namespace pass_planner
