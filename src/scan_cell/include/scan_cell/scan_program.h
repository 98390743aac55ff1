// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell/scan_request.h"

namespace scan_cell {

/// Passes to scan, in the form of a YAML file:
///
///     frame: world                 # of the poses
///     passes:
///       - name: outer flank        # may be left out
///         line:                    # poses of the flange, metres
///           start: {translation: [x, y, z], rotation: [x, y, z, w]}
///           end:   {translation: [x, y, z], rotation: [x, y, z, w]}
///         speed: 0.05              # [m/s]
///         rate: 100                # [Hz]
///         laser: 0                 # 0, 1, each or alternate
///         camera:                  # may be left out, and each of its entries
///           exposure: 0.0005       # [s]
///           region: {x: 336, y: 599, width: 1024, height: 512}   # [px] of the sensor
///           detector: fir_derivative   # of the camera's node
///
/// Instead of `line`: `arc` with start, via and end, or `poses` with a list. A file with start,
/// end, speed, rate and laser instead of `passes` is one line.
struct ScanProgram {
  std::string frame;             //!< of the poses
  std::vector<ScanPass> passes;  //!< poses in `frame`
};

/// @throw scan_cell_common::FileError if the file is missing or not YAML
/// @throw scan_cell_common::UnusableInput naming the entry that is missing or invalid
ScanProgram load_scan_program(const std::string& path);

/// Writes a program as load_scan_program() reads it, to the last digit; whole or not at all.
/// @param program with passes that check() accepts
/// @throw scan_cell_common::FileError if it cannot be written
void save_scan_program(const std::string& path, const ScanProgram& program);

}  // namespace scan_cell
