// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "scan_calibration/calibration_run.h"
#include "scan_cell/scan_request.h"
#include "sequence/scan_sequence.h"
#include "sequence/session_sequence.h"

namespace scan_cell {

/// Parameters of scan_cell_node.
struct Parameters {
  std::string base_frame = "base_link";  //!< frame the robot's driver takes targets in
  std::string flange_frame = "tool0";    //!< frame that the robot's driver publishes on /tf
  std::string robot = "/c4g_driver";     //!< node with the action ~move and the topic ~status
  std::string camera = "/camera";        //!< node with ~set_acquisition and ~profiles
  std::string trigger =
      "/laser_trigger";  //!< node with ~arm, ~disarm, ~keep_alive, ~events, ~state
  std::string binder = "/pose_frame_binder";           //!< node with ~start and ~finish
  std::string triangulation = "/laser_triangulation";  //!< node with ~start, ~finish and ~cloud
  double lost_after = 0.75;    //!< [s] of silence after which a device is lost
  double unseen_after = 0.05;  //!< [s] without a pose in mid motion after which the lasers go off
  double call_timeout = 5.0;   //!< [s] the longest a service may take to answer
  ScanLimits limits;
  ScanSequence::Timing timing;
  SessionLimits session_limits;
  SessionSequence::Timing session;  //!< of calibration sessions; stall as in timing
  scan_calibration::CalibrationLimits
      calibration_limits;  //!< what a model must reach to be written

  /// [s] of silence that a device which ticks at `rate` [Hz] may keep: five periods where that is
  /// longer, up to one second.
  double silence_allowed(double rate) const;

  /// @throw scan_cell_common::InvalidParameter
  static Parameters load(const ros::NodeHandle& node);
};

}  // namespace scan_cell
