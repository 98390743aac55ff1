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
  CellOptions options;  //!< without what scanner and cell file tell
  ControllerOptions controller;
  double true_flange_rate = 10;  //!< [Hz]
};

/// With range, unit and meaning of each.
void describe(scan_cell_common::ParameterTable& table, Parameters& parameters);

/// Names the package's own files where none are given.
/// @param config the package's folder of these
void complete(Parameters& parameters, const std::string& config);

}  // namespace scan_cell_sim
