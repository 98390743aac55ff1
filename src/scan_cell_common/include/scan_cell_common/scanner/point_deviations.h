// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_cell_common {

constexpr double kMaxPointDeviation = 0.1;  //!< [m] that a file may say; chosen: nobody scans so

/// How well the calibration knows a scanned point: [m] root of the summed variances along x, y and
/// z in tool0, by laser; 0 of a laser that is not known, empty where the file does not say (entry
/// `uncertainty`).
/// @throw FileError, UnusableInput as load_scanner_model()
std::vector<double> load_point_deviations(const std::string& path);

/// The same from the text of a file.
/// @param name in errors
std::vector<double> parse_point_deviations(const std::string& text, const std::string& name);

/// save_scanner_model() with them.
/// @param existing text of the file that parts were taken from; empty: none
/// @throw UnusableInput naming a deviation that no reader would take; nothing is written
void save_scanner_model(const std::string& path, const ScannerModel& model,
                        const std::string& existing, const std::vector<double>& deviations);

}  // namespace scan_cell_common
