// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scan_cell/scan_request.h"

namespace scan_cell {

/// Where a motion goes.
struct MoveTarget {
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();  //!< tool0, in the frame of the passes
  std::optional<Eigen::Isometry3d> via;  //!< on the arc to it; none: along a line
};

/// Which lasers are on while the camera is pulsed.
struct Lighting {
  std::uint8_t lasers = 0;  //!< bit mask, TriggerEvent.LASER_*
  bool alternate = false;   //!< both take turns, pulse by pulse, laser_0 first
  double exposure = 0;      //!< [s] of the camera; 0: not known
};

/// One motion along a pass with one setting of the lasers: the trigger is armed once.
struct ScanRun {
  std::size_t pass = 0;           //!< from 0
  std::string name;               //!< of the pass, for a person
  bool approach = true;           //!< the run before ends elsewhere
  Eigen::Isometry3d start;        //!< of the flange
  std::vector<MoveTarget> moves;  //!< from the start on, one after the other
  double speed = 0;               //!< [m/s]
  double rate = 0;                //!< [Hz]
  Lighting lighting;              //!< while it moves
  PassCamera camera;              //!< its settings
};

/// Splits passes into runs. A pass with each laser is two runs, there and back.
/// @param passes that check() accepts
std::vector<ScanRun> runs_of(const std::vector<ScanPass>& passes);

}  // namespace scan_cell
