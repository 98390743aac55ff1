// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "c4g_driver/motion.h"
#include "robot/paths/path.h"

namespace c4g_driver {

/// Where a motion that passed its check ends, and how it may be run.
struct MotionEnd {
  double max_override;  // [%] the highest at which it keeps to the speeds
  Joints joints;        // [rad]
  Eigen::Isometry3d flange;
};

/// @throw scan_cell_common::Refused if the model does not put the flange where it was measured
void check_model(const RobotModel& robot, const RobotState& state);

/// Whether the robot can carry out a motion from where it stands: followed in small steps before
/// anything is sent. What is refused names the joint or axis, its value, and where on the way.
///
/// The ranges and the box are taken wider where the robot stands outside them, so that it may come
/// back.
class MotionCheck {
 public:
  /// @param limits narrowed() to the robot
  /// @param from the robot at rest
  /// @throw scan_cell_common::Refused if the model does not put the flange where it was measured
  MotionCheck(const RobotModel& robot, const RobotLimits& limits, const RobotState& from,
              const MotionSettings& settings);

  /// One that check_goal() takes. @throw scan_cell_common::Refused
  MotionEnd run(const Motion& motion) const;

  /// A MOVE_CARTESIAN: within the ranges and speeds of the joints, no singular posture, and no
  /// turning over of the wrist, along the whole line.
  /// @param target within the box
  /// @throw scan_cell_common::Refused
  MotionEnd to_pose(const Eigen::Isometry3d& target) const;

  /// A MOVE_CIRCULAR: the same along the whole arc, which leaves the box nowhere.
  /// @param via, target within the box
  /// @throw scan_cell_common::Refused also if there is no one arc
  MotionEnd along_arc(const Eigen::Isometry3d& via, const Eigen::Isometry3d& target) const;

  /// A MOVE_JOINT: within the box along the whole way.
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
