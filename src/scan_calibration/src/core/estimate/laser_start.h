// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace scan_calibration {

/// A plane through points that may be wrong by half (least median of squares over many triples,
/// then a singular value decomposition of those near it).
struct PlaneFit {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
  double distance = 0;   //!< [m] normal . p = distance
  double across = 0;     //!< [m] RMS of the points near it, across their line within the plane
  double off_plane = 0;  //!< [m] RMS of the points near it
};

/// @param points [m] in camera_optical_frame, at least three
PlaneFit fit_plane(const std::vector<Eigen::Vector3d>& points);

/// @param name of the laser
/// @throw scan_cell_common::UnusableInput if the points lie on one line, or the plane goes through
/// the lens
void check_plane(const PlaneFit& plane, const std::string& name);

}  // namespace scan_calibration
