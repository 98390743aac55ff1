// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/ScanAction.h>

#include <string>
#include <vector>

#include "scan_cell/ros/cell_watcher.h"
#include "scan_cell/scan_program.h"
#include "scan_cell/videe_command.h"
#include "scan_cell_common/ros/goal_client.h"
#include "videe/goals_under_way.h"
#include "videe/kept_cloud.h"
#include "videe/videe_calibration.h"
#include "videe/videe_server.h"

namespace scan_cell {

/// Carries out the ViDeE commands on the cell.
class VideeCell {
 public:
  /// @throw scan_cell_common::Error if the scan program cannot be used
  VideeCell(ros::NodeHandle node, const VideeParameters& parameters);

  /// @return the text after OK
  /// @throw scan_cell_common::Error, also if the client goes away during the wait
  std::string carry_out(const VideeCommand& command, const VideeServer::ClientThere& client_there);

  /// Cancels the scan or calibration of a client that is gone, since it no longer watches.
  void on_client_lost();

 private:
  std::string grab_image();
  std::string set_position(const VideeCommand& command);
  std::string start_scan();
  std::string wait_scan(const VideeServer::ClientThere& client_there);
  std::string stop_scan(const VideeServer::ClientThere& client_there);
  /// @throw scan_cell_common::FileError if the cloud cannot be saved; the next STOP_SCAN tries
  /// again
  KeptCloud keep(const scan_cell_msgs::ScanResult& scan);
  void end_own();
  void end_all();

  ros::NodeHandle node_;
  const VideeParameters parameters_;
  const ScanProgram program_;
  const CellWatcher watcher_;
  GoalsUnderWay scans_;
  GoalsUnderWay calibrations_;
  scan_cell_common::GoalClient<scan_cell_msgs::ScanAction> client_;
  VideeCalibration calibration_;
  std::vector<Eigen::Isometry3d> positions_;
  bool running_ = false;
  bool stopped_ = false;  // by STOP_SCAN
  int images_ = 0;
};

}  // namespace scan_cell
