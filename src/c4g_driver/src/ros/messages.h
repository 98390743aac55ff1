// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <scan_cell_msgs/CheckFollow.h>
#include <scan_cell_msgs/CheckMotions.h>
#include <scan_cell_msgs/FollowGoal.h>
#include <scan_cell_msgs/MoveGoal.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include <array>
#include <string>

#include "c4g_driver/client.h"
#include "c4g_driver/tool_check.h"
#include "c4g_driver/tool_motion.h"

/// Conversions between the driver's types and messages.
namespace c4g_driver {

/// The transform message, to be updated with each pose.
tf2_msgs::TFMessage transform_message(const std::string& base_frame,
                                      const std::string& flange_frame);
/// @param names of the joints in the URDF
sensor_msgs::JointState joint_message(const std::array<std::string, 6>& names);

/// Sets stamp and numbers, without allocating memory.
void update(geometry_msgs::TransformStamped& message, const MeasuredState& state);
void update(sensor_msgs::JointState& message, const MeasuredState& state);

geometry_msgs::PoseStamped to_pose(const MeasuredState& state, const std::string& base_frame);

/// @param state the latest, of any age; none if there never was one
scan_cell_msgs::RobotStatus to_status(const LinkReport& link,
                                      const std::optional<MeasuredState>& state);

/// @throw scan_cell_common::Refused for an unknown kind, poses in another frame, or an invalid
/// quaternion
Motion to_motion(const scan_cell_msgs::MoveGoal& goal, const std::string& base_frame);

/// @throw scan_cell_common::Refused for another frame or an invalid quaternion
ToolMotion to_tool_motion(const scan_cell_msgs::FollowGoal& goal, const std::string& base_frame);

/// @param check of the path from `from` on
/// @param from first waypoint checked, counted from 0
void fill_in(scan_cell_msgs::CheckFollow::Response& response, const ToolCheck& check,
             std::size_t from);

/// @param plan result that the answer reports
void fill_in(scan_cell_msgs::CheckMotions::Response& response, const PlanCheck& plan,
             const std::string& base_frame);

}  // namespace c4g_driver
