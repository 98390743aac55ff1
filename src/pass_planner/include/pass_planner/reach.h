// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "c4g_driver/limits.h"
#include "c4g_driver/robot_model.h"
#include "scan_cell/scan_request.h"

namespace pass_planner {

/// Where the robot stands, and its limits.
struct RobotInCell {
  std::string urdf;                                                      //!< its text
  c4g_driver::RobotLimits limits;                                        //!< as the driver has them
  Eigen::Isometry3d base_link_in_world = Eigen::Isometry3d::Identity();  //!< the base in the cell
  std::string frame = "world";  //!< of the passes: world or base_link
  /// [rad] before the first pass; by default looking down 0.8 m in front of the base
  c4g_driver::Joints start = (c4g_driver::Joints() << 0, 0.14, -2.16, 0, 0.84, 0).finished();
  double approach_speed = 0.2;  //!< [m/s] to the start of a pass
};

/// Pose of the robot's base in the passes' frame.
/// @throw scan_cell_common::InvalidParameter if that is neither world nor base_link
Eigen::Isometry3d base_link_in_frame(const RobotInCell& robot);

/// Checks by the driver's own check of whole programs whether the robot can run passes.
class Reach {
 public:
  /// @throw scan_cell_common::InvalidParameter if the URDF, the frame or a limit makes no sense
  explicit Reach(const RobotInCell& robot);

  /// Why the robot cannot run these passes one after the other, each after a line to its start;
  /// empty: it can. Names the pass and the place on the way.
  std::string refusal(const std::vector<scan_cell::ScanPass>& passes) const;

  /// Pose of the flange in the passes' frame before the first pass.
  Eigen::Isometry3d start() const;

  /// Pose of the passes' frame in world.
  Eigen::Isometry3d frame_in_world() const;

 private:
  RobotInCell robot_;
  c4g_driver::RobotModel model_;
  Eigen::Isometry3d base_link_;  // in the passes' frame
};

}  // namespace pass_planner
