// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "geometry/board_view.h"

namespace scan_calibration {

/// A plane through points.
struct PlaneFit {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
  double distance = 0;   //!< [m] normal . p = distance
  double across = 0;     //!< [m] RMS of the points near it, across their line within the plane
  double off_plane = 0;  //!< [m] RMS of the points near it
};

/// A plane by total least squares. @param points [m], at least three
PlaneFit plane_through(const std::vector<Eigen::Vector3d>& points);

/// A robust plane: up to half of the points may be wrong (least median of squares over many
/// triples, then total least squares of the points near it).
/// @param points [m] in camera_optical_frame, at least three
PlaneFit fit_plane(const std::vector<Eigen::Vector3d>& points);

/// The points of a laser's line on the boards [m, camera_optical_frame].
/// @param boards where the camera has the board, per view
/// @throw scan_cell_common::UnusableInput if there are fewer than three
std::vector<Eigen::Vector3d> laser_points(const ScannerState& state, const BoardSurface& surface,
                                          const BoardViews& views,
                                          const std::vector<Eigen::Isometry3d>& boards,
                                          std::size_t laser, const std::string& name);

/// @param name of the laser
/// @throw scan_cell_common::UnusableInput if the points lie on one line, or the plane passes
/// through the lens
void check_plane(const PlaneFit& plane, const std::string& name);

}  // namespace scan_calibration
