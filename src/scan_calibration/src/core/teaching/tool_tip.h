// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace scan_calibration {

/// Requirements on a taught tool tip.
struct ToolTipLimits {
  double max_condition = 50;   //!< of the least-squares problem; tilts of 20 degrees give about 8
  double max_residual = 2e-3;  //!< [m] by which a pose may miss the fixed point; chosen
};

/// Position of the tool's tip, and how well it is known.
struct ToolTip {
  Eigen::Vector3d tip;          //!< [m] in tool0
  Eigen::Vector3d fixed_point;  //!< [m] that was touched, in base_link
  Eigen::Vector3d deviation;    //!< [m] standard deviation of `tip` along x, y, z of tool0
  double condition;             //!< largest over least singular value
  double rms;                   //!< [m] of the misses
  double worst_residual;        //!< [m]
  std::size_t worst_pose;       //!< index of the pose with it
};

/// Tool tip from flange poses in which it touches one fixed point (thesis 5.3): the least-squares
/// solution of R_i tip + t_i = point.
/// @param flange poses of tool0 in base_link, at least three, turned about at least two axes
/// @throw scan_cell_common::UnusableInput, with the figure, if there are too few poses, their
/// orientations do not determine the tip, or a pose misses the point
ToolTip tool_tip_from_poses(const std::vector<Eigen::Isometry3d>& flange,
                            const ToolTipLimits& limits = {});

}  // namespace scan_calibration
