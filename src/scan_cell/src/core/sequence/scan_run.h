// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell/scan_request.h"
#include "sequence/devices.h"

namespace scan_cell {

/// Once along a pass with one setting of the lasers: the trigger is armed once.
struct ScanRun {
  std::size_t pass = 0;           //!< from 0
  std::string name;               //!< of the pass, for a person
  bool approach = true;           //!< it does not begin where the run before it ends
  Eigen::Isometry3d start;        //!< of the flange
  std::vector<MoveTarget> moves;  //!< from there on, one after the other
  double speed = 0;               //!< [m/s]
  double rate = 0;                //!< [Hz]
  Lighting lighting;              //!< while it moves
  PassCamera camera;              //!< its settings
};

/// A pass with each laser is two runs, there and back.
/// @param passes that check() takes
std::vector<ScanRun> runs_of(const std::vector<ScanPass>& passes);

}  // namespace scan_cell
