// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "devices/work_planner.h"

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"
#include "tool_paths/tool_path_files.h"

namespace scan_cell {

using scan_cell_common::Refused;
using scan_cell_msgs::WorkGoal;
using tool_path_programs::WaypointZ;

namespace {

WaypointZ waypoint_z_of(const WorkGoal& goal, WaypointZ otherwise) {
  if (goal.waypoint_z == WorkGoal::Z_INTO_PART) return WaypointZ::kIntoPart;
  if (goal.waypoint_z == WorkGoal::Z_OUT_OF_PART) return WaypointZ::kOutOfPart;
  return otherwise;
}

}  // namespace

WorkPlan WorkPlanner::plan(const WorkGoal& goal,
                           const tool_path_programs::AcceptedReport& report) const {
  tool_path_programs::ExportParameters process = parameters_.work.process;
  process.waypoint_z = waypoint_z_of(goal, process.waypoint_z);
  std::optional<DryRun> dry_run;
  if (goal.dry_run != 0) dry_run = parameters_.work.dry_run;
  WorkPlan plan = plan_of(tool_paths::load_tool_path(goal.path), process, report.in_air,
                          goal.from_waypoint, dry_run);
  const Eigen::Isometry3d base =
      transform(parameters_.base_frame, goal.frame.empty() ? "world" : goal.frame);
  for (WorkWaypoint& waypoint : plan.waypoints)
    waypoint.tip = base * waypoint.tip;
  plan.flange_to_tip = transform(parameters_.flange_frame, parameters_.work.tip_frame);
  return plan;
}

Eigen::Isometry3d WorkPlanner::transform(const std::string& to, const std::string& from) const {
  try {
    return scan_cell_common::from_ros(
        transforms_.lookupTransform(to, from, ros::Time(0), ros::Duration(1.0)).transform);
  } catch (const tf2::TransformException& error) {
    throw Refused("frame '" + from + "'", error.what(),
                  "start the node that publishes the calibrated frames");
  }
}

}  // namespace scan_cell
