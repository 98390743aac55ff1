// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "parameters/work_parameters.h"
#include "scan_calibration/calibration_run.h"
#include "scan_cell/scan_request.h"
#include "sequence/scan_sequence.h"
#include "sequence/session_sequence.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace scan_cell {

/// Parameters of scan_cell_node.
struct Parameters {
  std::string base_frame = "base_link";
  std::string flange_frame = "tool0";
  std::string robot = "/c4g_driver";
  std::string camera = "/camera";
  std::string trigger = "/laser_trigger";
  std::string binder = "/pose_frame_binder";
  std::string triangulation = "/laser_triangulation";
  double lost_after = 0.75;    //!< [s]
  double unseen_after = 0.05;  //!< [s]
  double call_timeout = 5.0;   //!< [s]
  ScanLimits limits;
  ScanSequence::Timing timing;
  SessionLimits session_limits;
  SessionSequence::Timing session;  //!< of calibration sessions; stall as in timing
  scan_calibration::CalibrationLimits
      calibration_limits;  //!< limits that a model must meet to be written
  WorkParameters work;

  /// Silence [s] allowed to a device that ticks at `rate` [Hz]: lost_after, or five periods if that
  /// is longer, up to one second.
  double silence_allowed(double rate) const;
};

/// Adds each parameter with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, Parameters& parameters);

}  // namespace scan_cell
