// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_planner/tool_path_check.h"

#include <fmt/format.h>

#include <cmath>

#include "c4g_driver/motion_plan.h"

namespace pass_planner {

using tool_path_programs::MotionKind;
using tool_path_programs::Move;

PathForRobot path_for_robot(const tool_paths::ToolPath& path,
                            const tool_path_programs::ExportParameters& parameters,
                            const Eigen::Isometry3d& frame_in_base_link,
                            const Eigen::Isometry3d& tip_in_flange) {
  const tool_path_programs::Program program =
      tool_path_programs::program_of(path, parameters, {}, {});
  PathForRobot result;
  result.frame_in_base_link = frame_in_base_link;
  result.motion.flange_to_tip = tip_in_flange;
  for (const Move* move : moves_of(program)) {
    c4g_driver::ToolWaypoint waypoint;
    waypoint.tip = frame_in_base_link * move->pose;
    waypoint.speed = move->kind == MotionKind::kJoint ? parameters.travel_speed : move->speed;
    waypoint.zone = move->zone;
    result.motion.waypoints.push_back(waypoint);
    result.waypoint.push_back(move->waypoint);
  }
  return result;
}

tool_paths::ToolPath turned_path(tool_paths::ToolPath path, const PathForRobot& asked,
                                 const std::vector<Eigen::Isometry3d>& checked) {
  const Eigen::Matrix3d frame = asked.frame_in_base_link.linear();
  std::vector<Eigen::Matrix3d> turns;  // of each waypoint, about axes of the path's frame
  for (std::size_t i = 0; i < checked.size(); ++i) {
    if (!asked.waypoint[i]) continue;
    const Eigen::Matrix3d turn =
        checked[i].linear() * asked.motion.waypoints[i].tip.linear().transpose();
    turns.emplace_back(frame.transpose() * turn * frame);
  }
  std::size_t i = 0;
  for (tool_paths::Segment& segment : path.segments) {
    for (tool_paths::Waypoint& waypoint : segment.waypoints)
      waypoint.pose.linear() = turns[i++] * waypoint.pose.linear();
  }
  return path;
}

ToolPathCheck::ToolPathCheck(const RobotInCell& robot)
    : robot_(robot),
      model_(robot.urdf, "base_link", "flange"),
      frame_in_base_link_(base_link_in_frame(robot).inverse()) {
  robot_.limits = narrowed(robot.limits, model_);
}

c4g_driver::RobotState ToolPathCheck::start() const {
  c4g_driver::RobotState state;
  state.mode = c4g_driver::ControllerMode::kRemote;  // so that robot_.limits.operation decides
  state.joints = robot_.start;
  state.flange = model_.flange_at(robot_.start);
  return state;
}

c4g_driver::ToolCheck ToolPathCheck::check(const PathForRobot& path,
                                           const c4g_driver::ToolCheckParameters& parameters,
                                           const c4g_driver::CollisionScene* scene) const {
  return check_tool_motion(model_, robot_.limits, start(), path.motion, parameters, scene);
}

std::string ToolPathCheck::approach_refusal(const c4g_driver::ToolCheck& checked,
                                            double joint_speed) const {
  const c4g_driver::Joints& first = checked.joints.front();
  if (checked.stands_there || !first.allFinite()) return "";
  c4g_driver::Motion motion;
  motion.kind = c4g_driver::Motion::Kind::kToJoints;
  motion.joints.assign(first.begin(), first.end());
  c4g_driver::MotionSettings settings;
  settings.override = 100 * joint_speed;
  return check_plan(model_, robot_.limits, start(), settings, {{motion, std::nullopt}}).refusal;
}

}  // namespace pass_planner
