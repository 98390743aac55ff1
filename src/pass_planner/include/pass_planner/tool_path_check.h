// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "c4g_driver/cell_shapes.h"
#include "c4g_driver/tool_motion_check.h"
#include "pass_planner/reach.h"
#include "tool_path_programs/path_to_program.h"
#include "tool_path_programs/place_on_path.h"
#include "tool_paths/tool_path.h"

namespace c4g_driver {
class CollisionScene;
}

namespace pass_planner {

/// A tool path as the robot follows it: approaches, waypoints and retracts.
struct PathForRobot {
  Eigen::Isometry3d frame_in_base_link;        //!< the path's own frame [m]
  c4g_driver::ToolMotion motion;               //!< in base_link
  tool_path_programs::PathWaypoints waypoint;  //!< of each of the motion
};

/// @param tip_in_flange [m] pose of the tool's tip
/// @throw scan_cell_common::Error as program_of() of tool_path_programs
PathForRobot path_for_robot(const tool_paths::ToolPath& path,
                            const tool_path_programs::ExportParameters& parameters,
                            const Eigen::Isometry3d& frame_in_base_link,
                            const Eigen::Isometry3d& tip_in_flange);

/// The path with the orientations that its check gave the tool, in the path's own frame.
/// @param checked tips of the checked motion, in base_link
tool_paths::ToolPath turned_path(tool_paths::ToolPath path, const PathForRobot& asked,
                                 const std::vector<Eigen::Isometry3d>& checked);

/// The driver's check of a tool path, and of the joint motion to its start.
class ToolPathCheck {
 public:
  /// @param robot its approach_speed does not matter
  /// @throw scan_cell_common::InvalidParameter if the URDF, the frame or a limit makes no sense
  explicit ToolPathCheck(const RobotInCell& robot);

  /// The path's frame in base_link.
  Eigen::Isometry3d frame_in_base_link() const { return frame_in_base_link_; }

  const c4g_driver::RobotModel& model() const { return model_; }  //!< of the robot

  /// @param scene nothing may collide with it; none: collisions are not checked
  c4g_driver::ToolCheck check(const PathForRobot& path,
                              const c4g_driver::ToolCheckParameters& parameters,
                              const c4g_driver::CollisionScene* scene) const;

  /// Why the robot cannot move by the joints to the start of a checked path; empty: it can, or is
  /// there already.
  /// @param joint_speed share of the joints' own speed
  std::string approach_refusal(const c4g_driver::ToolCheck& checked, double joint_speed) const;

 private:
  c4g_driver::RobotState start() const;

  RobotInCell robot_;
  c4g_driver::RobotModel model_;
  Eigen::Isometry3d frame_in_base_link_;
};

}  // namespace pass_planner
