// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scan_cell/scan_request.h"

namespace pass_planner {

/// One poly-line through lines, each from the end that is nearer to the line before. Between them
/// the flange goes straight, and the camera is pulsed on.
/// @param lines at least one; where they have different lasers, the poly-line has both in turns
/// @param rate [Hz] frames a laser
scan_cell::ScanPass joined(std::vector<scan_cell::ScanPass> lines, double rate);

}  // namespace pass_planner
