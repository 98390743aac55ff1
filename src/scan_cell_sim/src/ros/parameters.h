// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell_sim/cell.h"
#include "scan_cell_sim/controller/controller.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace scan_cell_sim {

struct Parameters {
  std::string world;
  std::string scanner;
  std::string cell;
  CellOptions options;  //!< without what the scanner and cell files give
  ControllerOptions controller;
  double true_flange_rate = 10;  //!< [Hz]
};

/// Describes each parameter: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, Parameters& parameters);

/// Fills in the package's own files where none are given.
/// @param config the folder with these files
void complete(Parameters& parameters, const std::string& config);

}  // namespace scan_cell_sim
