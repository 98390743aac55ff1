// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "simulated_cell.h"

namespace scan_cell_demo {

/// The delay of the poses, estimated from two recorded scans by the suite's own command.
struct DelayTrial {
  double truth = 0;        //!< [s] by the simulator's true poses, see true_pose_delay()
  double estimate = 0;     //!< [s]
  double uncertainty = 0;  //!< [s] one standard deviation, as the command reports it
};

/// Scans there and back, and runs `estimate_time_offset`.
/// @param scanner file of the scanner model
/// @throw scan_cell_common::Refused if the command fails
DelayTrial try_delay(SimulatedCell& cell, const Motion& there, const Motion& back, double rate,
                     const std::string& scanner);

}  // namespace scan_cell_demo
