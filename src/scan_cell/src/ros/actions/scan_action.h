// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/CellState.h>
#include <scan_cell_msgs/CheckProgram.h>
#include <scan_cell_msgs/ScanAction.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <atomic>
#include <string>
#include <vector>

#include "actions/cell_action.h"
#include "actions/cell_devices.h"
#include "devices/ros_stages.h"
#include "parameters/parameters.h"
#include "sequence/program_check.h"
#include "sequence/scan_sequence.h"

namespace scan_cell {

/// The action ~scan and the service ~check_program.
class ScanAction : private ScanObserver, private CellAction<scan_cell_msgs::ScanAction>::Work {
 public:
  /// @param node the private node handle
  ScanAction(ros::NodeHandle node, const Parameters& parameters, CellDevices& devices,
             CellInUse& cell, const StateTopic& state);

  /// Cancels a scan in progress, if any, and waits until the cell is safe.
  ~ScanAction() override;

 private:
  std::string accept(const scan_cell_msgs::ScanGoal& goal) override;
  scan_cell_msgs::ScanResult run(const WhyToCancel& why_to_cancel) override;

  bool check_program(scan_cell_msgs::CheckProgram::Request& request,
                     scan_cell_msgs::CheckProgram::Response& response);

  /// @throw scan_cell_common::Refused
  ScanRequest request_from(const std::vector<scan_cell_msgs::ScanPass>& passes,
                           const std::string& frame) const;
  Eigen::Isometry3d base_to(const std::string& frame) const;

  void on_progress(const ScanProgress& progress) override;
  void on_capture_begins() override;
  void on_capture_ends() override;
  void publish_state(std::uint8_t state, const std::string& message);

  const Parameters parameters_;
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_{transforms_};
  RosCamera& camera_;
  RosStages stages_;
  const AskedBefore asked_;
  ScanSequence sequence_;
  const StateTopic& state_;
  std::atomic<std::uint64_t> points_{0};
  ros::Subscriber cloud_subscriber_;
  ros::WallTime last_feedback_;
  int last_step_ = 0;
  ScanRequest request_;
  ros::ServiceServer check_program_;
  CellAction<scan_cell_msgs::ScanAction> action_;  // last: its callbacks use the others
};

}  // namespace scan_cell
