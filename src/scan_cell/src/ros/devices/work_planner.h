// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/WorkGoal.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <string>

#include "parameters/parameters.h"
#include "tool_path_programs/accepted_report.h"
#include "work/work_plan.h"

namespace scan_cell {

/// Turns the goal of a work into the plan that the robot follows, in its base frame.
class WorkPlanner {
 public:
  explicit WorkPlanner(const Parameters& parameters) : parameters_(parameters) {}

  /// @param report that accepted the goal's path
  /// @throw scan_cell_common::Error as load_tool_path() and plan_of(); Refused if a frame is
  /// unknown
  WorkPlan plan(const scan_cell_msgs::WorkGoal& goal,
                const tool_path_programs::AcceptedReport& report) const;

 private:
  Eigen::Isometry3d transform(const std::string& to, const std::string& from) const;

  const Parameters parameters_;
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_{transforms_};
};

}  // namespace scan_cell
