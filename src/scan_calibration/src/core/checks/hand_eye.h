// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace scan_calibration {

/// The camera's pose on the flange, the board's in the base, and how well each view agrees.
struct HandEye {
  Eigen::Isometry3d flange_to_camera = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d base_to_board = Eigen::Isometry3d::Identity();
  double scale = 1;            //!< factor of the camera's lengths
  double scale_deviation = 0;  //!< standard deviation
  std::vector<bool> fits;      //!< per view
  std::vector<bool> turned;    //!< per view: fits with the board turned by half a turn
  std::vector<double> offset;  //!< [m] per view: of the board from where the others put it
  std::vector<double> angle;   //!< [rad] per view: the same of its orientation
  std::size_t count = 0;       //!< of the views that fit
};

/// Robust hand-eye calibration: rotation from the best of many triples of views (Park and Martin
/// 1994 on each), then from all views that agree; translation, board and scale by reweighted linear
/// least squares. Deterministic.
/// @param flange base_to_flange of each view [m]
/// @param board camera_to_board of each view [m]
/// @param half_turn of the board in its plane, which its corners may not show
HandEye fit_hand_eye(const std::vector<Eigen::Isometry3d>& flange,
                     const std::vector<Eigen::Isometry3d>& board,
                     const Eigen::Isometry3d& half_turn);

/// The same for a known pose of the camera on the flange: the board's pose, and how well each view
/// agrees. `scale` stays 1.
HandEye fit_board(const Eigen::Isometry3d& flange_to_camera,
                  const std::vector<Eigen::Isometry3d>& flange,
                  const std::vector<Eigen::Isometry3d>& board, const Eigen::Isometry3d& half_turn);

}  // namespace scan_calibration
