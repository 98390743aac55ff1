// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "scan_cell/scan_request.h"

namespace pass_planner {

/// The motion along one pass with one laser on.
struct Sweep {
  std::size_t pass = 0;                   //!< of the program, from 0
  std::size_t laser = 0;                  //!< index into scan_cell_common::ScannerModel::lasers
  std::vector<Eigen::Isometry3d> flange;  //!< tool0 in the program's frame, in small steps
  std::optional<scan_cell::CameraRegion> region;  //!< to read out; none: as set before
};

/// One sweep for each laser of each pass, in their order.
/// @param passes that scan_cell::check() takes
/// @throw scan_cell_common::Refused naming the pass whose poses have no arc
std::vector<Sweep> sweeps_of(const std::vector<scan_cell::ScanPass>& passes);

}  // namespace pass_planner
