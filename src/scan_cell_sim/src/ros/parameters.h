// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "scan_cell_sim/cell.h"
#include "scan_cell_sim/controller/controller.h"

namespace scan_cell_sim {

struct Parameters {
  std::string world;    //!< world file; the package's reference_frame.yaml
  std::string scanner;  //!< scanner model as it truly is; the package's scanner.yaml
  std::string cell;     //!< cell file; the package's cell.yaml
  CellOptions options;  //!< without what scanner and cell file tell
  ControllerOptions controller;
  double true_flange_rate = 10;  //!< [Hz]

  /// @throw scan_cell_common::InvalidParameter
  static Parameters load(const ros::NodeHandle& node);
};

}  // namespace scan_cell_sim
