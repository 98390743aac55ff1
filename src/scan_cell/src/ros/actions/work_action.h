// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/WorkAction.h>

#include <string>

#include "actions/cell_action.h"
#include "actions/cell_devices.h"
#include "devices/work_planner.h"
#include "parameters/parameters.h"
#include "work/work_permit.h"
#include "work/work_record.h"
#include "work/work_sequence.h"

namespace scan_cell {

/// The action ~work.
class WorkAction : private WorkObserver, private CellAction<scan_cell_msgs::WorkAction>::Work {
 public:
  /// @param node the private node handle
  WorkAction(ros::NodeHandle node, const Parameters& parameters, CellDevices& devices,
             const WorkPlanner& planner, CellInUse& cell, const StateTopic& state);

  /// Cancels work in progress, if any, and waits until the robot stands.
  ~WorkAction() override;

 private:
  std::string accept(const scan_cell_msgs::WorkGoal& goal) override;
  scan_cell_msgs::WorkResult run(const WhyToCancel& why_to_cancel) override;
  void on_progress(const std::string& doing, double progress) override;
  void on_passed(const WorkWaypoint& waypoint) override;

  CalibrationNow calibration() const;
  SequenceEnd kept(SequenceEnd end) const;

  const ros::NodeHandle node_;
  const Parameters parameters_;
  const WorkPlanner& planner_;
  const DryRuns dry_runs_;
  WorkSequence sequence_;
  scan_cell_msgs::WorkGoal goal_;
  tool_path_programs::AcceptedReport report_;
  WorkPlan plan_;
  std::size_t waypoints_ = 0;  // of the path
  WorkRecord record_;
  ros::WallTime last_feedback_;
  CellAction<scan_cell_msgs::WorkAction> action_;  // last: its callbacks use the others
};

}  // namespace scan_cell
