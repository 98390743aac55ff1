// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "actions/work_action.h"

#include <algorithm>
#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/sha256.h"

namespace scan_cell {

using scan_cell_common::Refused;
using scan_cell_msgs::WorkGoal;
using scan_cell_msgs::WorkResult;

namespace {

/// SHA-256 of a file; empty if it is not on this machine.
std::string hash_of(const std::string& file) {
  try {
    return scan_cell_common::sha256_of_file(file);
  } catch (const scan_cell_common::FileError&) {
    return "";
  }
}

}  // namespace

WorkAction::WorkAction(ros::NodeHandle node, const Parameters& parameters, CellDevices& devices,
                       const WorkPlanner& planner, CellInUse& cell, const StateTopic& state)
    : node_(node),
      parameters_(parameters),
      planner_(planner),
      dry_runs_(parameters.work.dry_runs),
      sequence_(devices.robot, devices.robot, devices.trigger, *this, parameters.timing),
      action_(node, "work", cell, state, *this) {
  action_.start();
}

WorkAction::~WorkAction() {
  action_.end();
}

std::string WorkAction::accept(const WorkGoal& goal) {
  goal_ = goal;
  const bool dry = goal.dry_run != 0;
  report_ = tool_path_programs::accepted_report(goal.report, goal.path);
  check_permit(report_, calibration(), parameters_.work.rules, dry_runs_, dry,
               ros::Time::now().toSec());
  if (!goal.record.empty()) {
    scan_cell_common::refuse_overwriting(goal.record, {goal.path, goal.report});
    scan_cell_common::check_output(goal.record, {".json"}, "write the record as .json");
  }
  plan_ = planner_.plan(goal, report_);
  waypoints_ =
      goal.from_waypoint + static_cast<std::size_t>(std::count_if(
                               plan_.waypoints.begin(), plan_.waypoints.end(),
                               [](const auto& each) { return each.waypoint.has_value(); }));
  record_ = WorkRecord();
  return goal.path;
}

/// Reads both files now, so that a calibration made since this node started counts.
CalibrationNow WorkAction::calibration() const {
  std::string scanner;
  std::string cell;
  node_.getParam(parameters_.work.frames + "/scanner_file", scanner);
  node_.getParam(parameters_.work.frames + "/cell_file", cell);
  return {hash_of(scanner), hash_of(cell)};
}

WorkResult WorkAction::run(const WhyToCancel& why_to_cancel) {
  const ros::WallTime start = ros::WallTime::now();
  const SequenceEnd end = kept(sequence_.run(plan_, why_to_cancel));
  WorkResult result;
  result.outcome = static_cast<std::uint8_t>(end.outcome);
  result.message = end.message;
  result.waypoints = static_cast<std::uint32_t>(waypoints_);
  result.passed = static_cast<std::uint32_t>(record_.waypoints());
  result.seconds = (ros::WallTime::now() - start).toSec();
  if (end.outcome != Outcome::kFinished)
    ROS_WARN("Work on '%s' ended early: %s", goal_.path.c_str(), end.message.c_str());
  return result;
}

/// Records what was done, however it ended, and a dry run that was finished.
SequenceEnd WorkAction::kept(SequenceEnd end) const {
  try {
    const bool dry = goal_.dry_run != 0;
    if (dry && end.outcome == Outcome::kFinished && goal_.from_waypoint == 0)
      dry_runs_.add(report_.proven_path, report_.cell, ros::Time::now().toSec());
    if (!goal_.record.empty())
      scan_cell_common::save_text(goal_.record, record_.text(end, goal_.path, dry));
  } catch (const scan_cell_common::Error& error) {
    worsen(end, Outcome::kMotionFailed, error.what());
  }
  return end;
}

void WorkAction::on_progress(const std::string& doing, double progress) {
  constexpr double kPeriod = 0.1;  // [s] chosen
  const ros::WallTime now = ros::WallTime::now();
  if (progress < 1 && (now - last_feedback_).toSec() < kPeriod) return;
  last_feedback_ = now;
  scan_cell_msgs::WorkFeedback feedback;
  feedback.doing = doing;
  feedback.progress = progress;
  feedback.passed = static_cast<std::uint32_t>(record_.waypoints());
  action_.publish(feedback);
}

void WorkAction::on_passed(const WorkWaypoint& waypoint) {
  record_.passed(waypoint, ros::Time::now().toSec());
}

}  // namespace scan_cell
