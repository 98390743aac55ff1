// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell_common/parameters/parameter_table.h"
#include "teaching/light_sheet.h"

namespace scan_calibration {

struct CalibratedFramesParameters {
  std::string scanner_file;
  std::string cell_file;
  SheetSize light_sheet;
};

inline void describe(scan_cell_common::ParameterTable& table, SheetSize& size) {
  table.add("opening", size.opening, {0.01, 3, "rad"}, "opening angle of the drawn sheet of light");
  table.add("length", size.length, {0, 10, "m"},
            "length of the drawn sheet of light; 0: to where it crosses the optical axis");
}

inline void describe(scan_cell_common::ParameterTable& table,
                     CalibratedFramesParameters& parameters) {
  table.require("scanner_file", parameters.scanner_file,
                "the scanner model: camera, its pose on the flange, laser planes");
  table.require("cell_file", parameters.cell_file, "`cell.yaml`, below");
  table.group("light_sheet", parameters.light_sheet);
}

}  // namespace scan_calibration
