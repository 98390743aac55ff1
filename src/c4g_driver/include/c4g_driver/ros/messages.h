// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <scan_cell_msgs/MoveGoal.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <sensor_msgs/JointState.h>

#include <array>
#include <string>

#include "c4g_driver/client.h"

/// The driver's states as messages.
namespace c4g_driver {

geometry_msgs::TransformStamped to_transform(const MeasuredState& state,
                                             const std::string& base_frame,
                                             const std::string& flange_frame);

geometry_msgs::PoseStamped to_pose(const MeasuredState& state, const std::string& base_frame);

/// @param names of the joints in the URDF
sensor_msgs::JointState to_joint_state(const MeasuredState& state,
                                       const std::array<std::string, 6>& names);

/// @param state the latest, of any age; none if there never was one
scan_cell_msgs::RobotStatus to_status(const LinkReport& link,
                                      const std::optional<MeasuredState>& state);

/// The target of a Cartesian goal.
/// @throw scan_cell_common::Refused for another frame, or a quaternion that is none
Eigen::Isometry3d to_target(const geometry_msgs::PoseStamped& pose, const std::string& base_frame);

}  // namespace c4g_driver
