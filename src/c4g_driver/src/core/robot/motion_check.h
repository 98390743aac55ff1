// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "c4g_driver/motion.h"
#include "robot/paths/path.h"

namespace c4g_driver {

/// Where a motion that passed its check ends, and at what override it may run.
struct MotionEnd {
  double max_override;  // [%] the highest at which it keeps the speed limits
  Joints joints;        // [rad]
  Eigen::Isometry3d flange;
};

/// @throw scan_cell_common::Refused if the model does not put the flange where the controller
/// measured it
void check_model(const RobotModel& robot, const RobotState& state);

/// Checks whether the robot can carry out a motion from where it stands, by following it in small
/// steps before anything is sent. A refusal names the joint or axis, its value, and the place on
/// the way.
///
/// If the robot stands outside the ranges or the box, they are widened so that it may move back in.
class MotionCheck {
 public:
  /// @param limits narrowed() to the robot
  /// @param from the robot at rest
  /// @throw scan_cell_common::Refused if the model does not put the flange where the controller
  /// measured it
  MotionCheck(const RobotModel& robot, const RobotLimits& limits, const RobotState& from,
              const MotionSettings& settings);

  /// Checks a motion that check_goal() accepts. @throw scan_cell_common::Refused
  MotionEnd run(const Motion& motion) const;

  /// A MOVE_CARTESIAN: along the whole line the joints must stay within their ranges and speeds,
  /// without a singular posture or an axis that turns over.
  /// @param target within the box
  /// @throw scan_cell_common::Refused
  MotionEnd to_pose(const Eigen::Isometry3d& target) const;

  /// A MOVE_CIRCULAR: the same along the whole arc, which must also stay within the box.
  /// @param via, target within the box
  /// @throw scan_cell_common::Refused also if no single arc passes through the poses
  MotionEnd along_arc(const Eigen::Isometry3d& via, const Eigen::Isometry3d& target) const;

  /// A MOVE_JOINT: the flange must stay within the box along the whole way.
  /// @param target within the ranges
  /// @throw scan_cell_common::Refused
  MotionEnd to_joints(const Joints& target) const;

 private:
  MotionEnd along(const Path& path) const;
  Joints reach(const MotionPlace& target, const std::string& name) const;

  const RobotModel& robot_;
  const RobotState from_;
  const MotionSettings settings_;
  RobotLimits limits_;
  SpeedLimit speed_;
};

}  // namespace c4g_driver
