// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "c4g_driver/limits.h"
#include "c4g_driver/robot_model.h"
#include "robot/path.h"

namespace c4g_driver {

/// How the controller would carry out a motion now; parameters of c4g_protocol.md.
struct MotionSettings {
  bool in_joints = false;       //!< MOVE_CARTESIAN goes in joints
  bool euler = false;           //!< along a line A, E and R go each at its own rate
  double linear_speed = 0.25;   //!< [m/s] along a line or an arc
  double rotational_speed = 1;  //!< [rad/s] along it; the slower of both rules
  double override = 100;        //!< [%] of all speeds
};

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

  /// A MOVE_CARTESIAN: within the ranges and speeds of the joints, no singular posture, and no
  /// turning over of the wrist, along the whole line.
  /// @param target within the box
  /// @return [%] the highest override at which it keeps to the speeds
  /// @throw scan_cell_common::Refused
  double to_pose(const Eigen::Isometry3d& target) const;

  /// A MOVE_CIRCULAR: the same along the whole arc, which leaves the box nowhere.
  /// @param via, target within the box
  /// @return [%] the highest override at which it keeps to the speeds
  /// @throw scan_cell_common::Refused also if there is no one arc
  double along_arc(const Eigen::Isometry3d& via, const Eigen::Isometry3d& target) const;

  /// A MOVE_JOINT: within the box along the whole way.
  /// @param target within the ranges
  /// @return [%] the highest override at which it keeps to the speeds
  /// @throw scan_cell_common::Refused
  double to_joints(const Joints& target) const;

 private:
  double along(const Path& path) const;
  Joints reach(const Eigen::Isometry3d& target, const std::string& name) const;

  const RobotModel& robot_;
  const RobotState from_;
  const MotionSettings settings_;
  RobotLimits limits_;
  SpeedLimit speed_;
};

}  // namespace c4g_driver
