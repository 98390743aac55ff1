// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/CalibrateAction.h>

#include <string>

#include "scan_cell/ros/cell_watcher.h"
#include "scan_cell_common/ros/goal_client.h"
#include "videe/videe_parameters.h"
#include "videe/videe_server.h"

namespace scan_cell {

/// INIT_CALIBRATION and PERFORM_CALIBRATION.
class VideeCalibration {
 public:
  /// @param action of the cell
  /// @param watcher must outlive this object
  VideeCalibration(ros::NodeHandle node, const VideeCalibrationParameters& parameters,
                   const std::string& action, const CellWatcher& watcher, double call_timeout);

  /// Reads the taught poses.
  /// @return their number, as poses=N
  /// @throw scan_cell_common::Error if they cannot be used
  std::string init();

  /// Records a session and computes the model.
  /// @return the figures
  /// @throw scan_cell_common::Error, also if the client goes away during the wait
  std::string perform(const VideeServer::ClientThere& client_there);

  /// Ends a goal in progress; INIT_CALIBRATION is needed again.
  /// @throw scan_cell_common::ConnectionError if it does not end
  void reset();

 private:
  scan_cell_msgs::CalibrateGoal goal() const;

  const VideeCalibrationParameters parameters_;
  const std::string action_;
  const CellWatcher& watcher_;
  const double call_timeout_;
  scan_cell_common::GoalClient<scan_cell_msgs::CalibrateAction> client_;
  bool ready_ = false;    // the taught poses have been read
  bool running_ = false;  // a goal is in progress
};

}  // namespace scan_cell
