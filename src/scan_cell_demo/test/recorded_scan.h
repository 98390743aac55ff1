// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace scan_cell_demo {

/// Writes the bag of a scan of a world in the simulated cell, without running the cell: poses every
/// 4 ms, pulses at 100 Hz, and profiles from the renderer's images. Every 37th frame is lost. All
/// of it belongs to the fourth pass of its program.
/// @param start [s] since 1970: no two scans are at the same time
void record_scan(const std::string& bag, const std::string& scan_id, const std::string& world,
                 double start);

}  // namespace scan_cell_demo
