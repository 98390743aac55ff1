// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell/scan_request.h"

namespace scan_cell {

/// One line to scan, as people keep it in a YAML file:
///
///     frame: world                 # of the poses
///     start: {translation: [x, y, z], rotation: [x, y, z, w]}   # of the flange, metres
///     end:   {translation: [x, y, z], rotation: [x, y, z, w]}
///     speed: 0.05                  # [m/s]
///     rate: 100                    # [Hz]
///     laser: 0                     # 0 or 1
struct ScanProgram {
  std::string frame;    //!< of the poses
  ScanRequest request;  //!< poses in `frame`
};

/// @throw scan_cell_common::FileError if the file is missing or not YAML
/// @throw scan_cell_common::UnusableInput naming the entry that is missing or makes no sense
ScanProgram load_scan_program(const std::string& path);

}  // namespace scan_cell
