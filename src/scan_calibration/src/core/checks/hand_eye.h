// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace scan_calibration {

/// Where the camera sits on the flange and the board in the base, from poses of both, and how well
/// each view agrees.
struct HandEye {
  Eigen::Isometry3d flange_to_camera = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d base_to_board = Eigen::Isometry3d::Identity();
  double scale = 1;            //!< what the camera's lengths must be multiplied by
  double scale_deviation = 0;  //!< standard deviation
  std::vector<bool> fits;      //!< a view
  std::vector<bool> turned;    //!< a view: agrees if the board is taken as turned by half a turn
  std::vector<double> offset;  //!< [m] a view: of the board from where the others have it
  std::vector<double> angle;   //!< [rad] a view
  std::size_t count = 0;       //!< of the views that fit
};

/// Robust hand-eye: rotation from the best of many triples of views (Park and Martin 1994 on each),
/// then on all that agree; translation, board and scale by reweighted linear least squares. The
/// same views give the same result.
/// @param flange base_to_flange of each view [m]
/// @param board camera_to_board of each view [m]
/// @param half_turn of the board in its plane, which its corners cannot tell
HandEye fit_hand_eye(const std::vector<Eigen::Isometry3d>& flange,
                     const std::vector<Eigen::Isometry3d>& board,
                     const Eigen::Isometry3d& half_turn);

/// The same where it is known where the camera sits on the flange: the board's pose, and how well
/// each view agrees. `scale` stays 1.
HandEye fit_board(const Eigen::Isometry3d& flange_to_camera,
                  const std::vector<Eigen::Isometry3d>& flange,
                  const std::vector<Eigen::Isometry3d>& board, const Eigen::Isometry3d& half_turn);

/// Angle [rad] of a rotation.
double angle_of(const Eigen::Matrix3d& rotation);

}  // namespace scan_calibration
