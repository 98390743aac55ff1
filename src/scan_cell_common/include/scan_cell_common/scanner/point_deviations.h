// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_cell_common {

constexpr double kMaxPointDeviation = 0.1;  //!< [m] largest in a file; chosen: unusably large

/// How accurately the calibration knows a scanned point: root of the summed variances along x, y
/// and z in tool0 [m], by laser; 0 for a laser that is not known, empty if the file does not say
/// (entry `uncertainty`).
/// @throw FileError, UnusableInput as load_scanner_model()
std::vector<double> load_point_deviations(const std::string& path);

/// The same from the text of a file.
/// @param name of the text, for errors
std::vector<double> parse_point_deviations(const std::string& text, const std::string& name);

/// save_scanner_model() with point deviations.
/// @param existing text of the file from which parts were taken; empty: none
/// @throw UnusableInput naming a deviation that a reader would refuse; nothing is written
void save_scanner_model(const std::string& path, const ScannerModel& model,
                        const std::string& existing, const std::vector<double>& deviations);

}  // namespace scan_cell_common
