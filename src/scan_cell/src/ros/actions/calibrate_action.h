// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/CalibrateAction.h>

#include <memory>
#include <string>

#include "actions/cell_action.h"
#include "actions/cell_devices.h"
#include "parameters/parameters.h"
#include "scan_calibration/calibration_run.h"
#include "scan_calibration/session_recorder.h"
#include "sequence/session_sequence.h"

namespace scan_cell {

/// The action ~calibrate and the latched topic ~calibration with its result, for rviz.
class CalibrateAction : private SessionObserver,
                        private CellAction<scan_cell_msgs::CalibrateAction>::Work {
 public:
  /// @param node the private node handle
  CalibrateAction(ros::NodeHandle node, const Parameters& parameters, CellDevices& devices,
                  CellInUse& cell, const StateTopic& state);

  /// Cancels a calibration in progress, if any, and waits until the cell is safe.
  ~CalibrateAction() override;

 private:
  std::string accept(const scan_cell_msgs::CalibrateGoal& goal) override;
  scan_cell_msgs::CalibrateResult run(const WhyToCancel& why_to_cancel) override;
  SequenceEnd record(const WhyToCancel& why_to_cancel, scan_cell_msgs::CalibrateResult& result);
  void compute(const WhyToCancel& why_to_cancel, scan_cell_msgs::CalibrateResult& result);
  void save(const scan_calibration::CalibrationRun& found,
            scan_cell_msgs::CalibrateResult& result) const;

  void on_progress(int pose, const std::string& doing, double progress) override;
  void on_view(const TakenView& view) override;
  void tell(int pose, const std::string& doing, double progress);

  const Parameters parameters_;
  SessionSequence sequence_;
  ros::Publisher markers_publisher_;
  ros::WallTime last_feedback_;
  std::string last_doing_;
  double progress_ = 0;
  scan_cell_msgs::CalibrateGoal goal_;
  scan_calibration::CalibrationOptions options_;  // as requested by the goal
  SessionRequest request_;
  std::unique_ptr<scan_calibration::SessionRecorder> recorder_;  // while a session is recorded
  CellAction<scan_cell_msgs::CalibrateAction> action_;  // last: its callbacks use the others
};

}  // namespace scan_cell
