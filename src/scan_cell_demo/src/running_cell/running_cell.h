// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <scan_cell_msgs/ScanAction.h>
#include <scan_cell_msgs/SetFaults.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "running_cell/videe_client.h"
#include "scan_cell/scan_program.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/goal_client.h"

namespace scan_cell_demo {

/// Thrown if a scan ends by itself before the step that a test waits for.
class EndedBefore : public scan_cell_common::Refused {
 public:
  using Refused::Refused;
};

/// A client of a running simulated cell, with the simulator's ground truth of the robot's pose.
/// Callbacks must be served by another thread (ros::AsyncSpinner).
class RunningCell {
 public:
  explicit RunningCell(ros::NodeHandle node);

  /// Clears all faults and waits until robot, camera and cell are ready.
  /// @throw scan_cell_common::Refused if they are not ready after a minute
  void wait_until_well();

  /// Starts a scan of the shipped line from its farther end.
  void start_scan(const std::string& scan_id);

  /// Starts a scan with the shipped program of three passes.
  void start_program(const std::string& scan_id);

  /// Cancels the scan started by one of these two; returns at once.
  void stop_scan();

  /// Starts a scan as a client of videe_node, once that is up. The scan is named after the time.
  /// @throw scan_cell_common::Error if videe_node refuses
  void start_videe_scan(std::uint16_t port);

  /// Waits until the running scan has done `share` (0 .. 1) of `step` (1 .. 8).
  /// @throw EndedBefore if the scan ends before that
  void wait_for_step(int step, double share);

  /// Waits `time` [s] while the scan runs.
  /// @throw EndedBefore if the scan ends before that
  void wait_in_scan(double time);

  /// The step of the running scan, as last received.
  struct Step {
    std::uint32_t pass = 0;  // from 1; 0: none yet
    int step = 0;            // 1 .. 8; 0: none yet
  };
  Step step() const;

  /// Waits for the end of the scan.
  /// @return null if scan_cell_node died, and the result with it
  scan_cell_msgs::ScanResultConstPtr end();

  /// Sets faults over the connection that wait_until_well() made, so it takes effect at once.
  /// @throw scan_cell_common::Refused
  void set_faults(const scan_cell_msgs::SetFaults::Request& faults);

  /// Waits until the true flange stands still.
  /// @throw scan_cell_common::Refused if it still moves after a minute
  void wait_until_standing();

  /// Greatest distance [m] of the true flange from its present place within `time` [s].
  double way_within(double time);

  bool connected() const;

  /// The ends of the shipped line, as poses of the flange in base_link.
  std::vector<Eigen::Isometry3d> line_in_base() const;

 private:
  void on_feedback(const scan_cell_msgs::ScanActionFeedback& feedback);
  void on_result(const scan_cell_msgs::ScanActionResultConstPtr& result);
  void forget_last_scan();
  void start(const scan_cell::ScanProgram& program, const std::string& scan_id);
  scan_cell::ScanProgram line() const;
  scan_cell_msgs::ScanActionResultConstPtr result() const;
  void throw_if_ended() const;
  void on_flange(const geometry_msgs::PoseStamped& flange);
  void on_status(const scan_cell_msgs::RobotStatus& status);

  /// The true flange, in world.
  struct Seen {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    int heard = 0;                                     // messages since start_to_look()
    double still = 0;                                  // [s] at one place
    Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  // that place
    ros::Time since;
  };
  void start_to_look();
  Seen look() const;

  ros::NodeHandle node_;
  const scan_cell::ScanProgram line_;
  const scan_cell::ScanProgram program_;
  const Eigen::Isometry3d base_link_;  // in world
  mutable std::mutex mutex_;
  bool connected_ = false;
  Step step_;
  double progress_ = 0;                              // 0 .. 1, of the whole scan
  scan_cell_msgs::ScanActionResultConstPtr result_;  // none: it has not ended
  Seen flange_seen_;
  ros::ServiceClient faults_;
  std::optional<VideeClient> videe_;  // started the scan
  scan_cell_common::GoalClient<scan_cell_msgs::ScanAction> scan_{node_, "/scan_cell/scan"};
  ros::Subscriber feedback_;  // whoever started the scan
  ros::Subscriber results_;
  ros::Subscriber flange_;
  ros::Subscriber status_;
};

}  // namespace scan_cell_demo
