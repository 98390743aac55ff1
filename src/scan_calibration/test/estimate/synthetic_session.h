// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "scan_calibration/observations.h"
#include "scan_cell_common/scanner/scanner_model.h"

/// Sessions with known truth, made with OpenCV's projection and closed-form cuts of planes.
namespace synthetic {

/// The true cell, to be found.
struct Cell {
  Cell();  //!< a wide lens, two lasers 0.5 m apart that cross the axis at 0.5 m, a board of 20 mm
  scan_cell_common::ScannerModel scanner;
  Eigen::Isometry3d base_to_board;
  scan_calibration::Board board;
  Eigen::Vector3d bend = Eigen::Vector3d::Zero();  //!< as Calibration::board_bend
};

/// Standard deviations.
struct Noise {
  double corner_px = 0;  //!< along each axis
  double line_px = 0;    //!< of a peak's column, one peak a row
  double robot_m = 0;    //!< along each axis
  double robot_rad = 0;  //!< about each axis
};

/// How the camera was held.
struct Poses {
  int count = 70;
  double nearest = 0.38, farthest = 0.62;  //!< [m] from the board's middle
  double max_tilt = 0.6;                   //!< [rad]
  double max_roll = 0.8;                   //!< [rad] about the camera's axis
  double aside = 0.08;                     //!< [m] by which the axis misses the board's middle
  unsigned seed = 1;
};

/// Poses of the flange, in which the camera looks at the board.
std::vector<Eigen::Isometry3d> flange_poses(const Cell& cell, const Poses& poses);

/// The camera's view from these poses; the recorded poses have the robot's noise.
scan_calibration::Observations observe(const Cell& cell,
                                       const std::vector<Eigen::Isometry3d>& flange,
                                       const Noise& noise, unsigned seed);

/// The session for which the goals are stated: 70 views, 0.1 px, 0.05 mm.
scan_calibration::Observations goal_session(const Cell& cell, unsigned seed);

}  // namespace synthetic
