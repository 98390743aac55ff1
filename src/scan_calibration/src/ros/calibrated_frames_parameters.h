// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell_common/parameters/parameter_table.h"

namespace scan_calibration {

struct CalibratedFramesParameters {
  std::string scanner_file;
  std::string cell_file;
};

inline void describe(scan_cell_common::ParameterTable& table,
                     CalibratedFramesParameters& parameters) {
  table.require("scanner_file", parameters.scanner_file,
                "the scanner model: camera, its pose on the flange, laser planes");
  table.require("cell_file", parameters.cell_file, "`cell.yaml`, below");
}

}  // namespace scan_calibration
