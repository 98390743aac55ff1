// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace scan_cell_demo {

/// Writes the bag that a scan of a world in the simulated cell leaves, without running the cell:
/// poses every 4 ms, pulses at 100 Hz and the profiles that the renderer's images give. Every 37th
/// frame is lost. All of it belongs to the fourth pass of its program.
/// @param start [s] since 1970: two scans are never at the same time
void record_scan(const std::string& bag, const std::string& scan_id, const std::string& world,
                 double start);

}  // namespace scan_cell_demo
