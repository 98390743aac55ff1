// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell_common/scanner_model.h"

namespace scan_calibration {

/// A scanner model that was calibrated before, and gives what is not calibrated anew.
struct ExistingScanner {
  std::string file;
  std::string text;  //!< of the file, so that what is kept is written as it stands there
  scan_cell_common::ScannerModel model;
};

/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput as load_scanner_model()
ExistingScanner load_existing_scanner(const std::string& file);

/// Parts of a model that come from the existing one, by their names in its file: camera,
/// flange_to_camera, laser_0.
/// @param lasers that are calibrated anew
std::vector<std::string> kept_parts(const ExistingScanner& existing, bool lasers_alone,
                                    const std::vector<std::string>& lasers);

}  // namespace scan_calibration
