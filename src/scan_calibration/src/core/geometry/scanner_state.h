// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "scan_calibration/session.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_calibration {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// fx, fy, cx, cy, k1, k2, p1, p2, k3
using CameraVector = Eigen::Matrix<double, 9, 1>;

/// All unknowns of the estimate. A small motion of a pose is six numbers: a translation [m] and a
/// rotation vector [rad] along and about the pose's own axes.
struct ScannerState {
  int width = 0;   //!< [px]
  int height = 0;  //!< [px]
  CameraVector camera = CameraVector::Zero();
  Eigen::Isometry3d flange_to_camera = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d base_to_board = Eigen::Isometry3d::Identity();
  Eigen::Vector3d bend = Eigen::Vector3d::Zero();  //!< as Calibration::board_bend
  /// Per laser: normal / distance, so plane . p = 1: three free numbers for any plane that does not
  /// pass through the lens.
  std::vector<Eigen::Vector3d> planes;
  std::vector<Vector6d> corrections;  //!< per view: from the flange's measured pose to the true one

  scan_cell_common::CameraIntrinsics intrinsics() const;
};

CameraVector camera_vector(const scan_cell_common::CameraIntrinsics& camera);

/// The pose after a small motion.
Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Vector6d& motion);

/// The rotation vector [rad] of a rotation, its angle from 0 to pi.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation);

/// Angle [rad] of a rotation.
double angle_of(const Eigen::Matrix3d& rotation);

/// The nearest rotation.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix);

/// The model with its planes' normals towards the camera (distance below 0).
/// @param lasers of the planes
/// @param projectors of these lasers [m], where known
scan_cell_common::ScannerModel scanner_model(const ScannerState& state,
                                             const std::vector<std::string>& lasers,
                                             const std::vector<Eigen::Vector3d>& projectors);

/// The surface of a board that may be bent: z = basis(x, y) . bend. Beyond its corners, where
/// nothing is observed, it continues at the height of its border.
class BoardSurface {
 public:
  explicit BoardSurface(const Board& board);

  Eigen::Vector3d basis(const Eigen::Vector2d& place) const;

  /// Derivatives of the basis along x and y: one per row.
  Eigen::Matrix<double, 2, 3> slope(const Eigen::Vector2d& place) const;

  /// [m] on the board
  const Eigen::Vector2d& centre() const { return centre_; }

  /// The board turned in its plane by half a turn, which maps its corners onto each other.
  Eigen::Isometry3d half_turn() const;

 private:
  /// A place from -1 to 1 over the corners, and no further.
  Eigen::Vector2d unit_place(const Eigen::Vector2d& place) const;

  Eigen::Vector2d centre_;
  Eigen::Vector2d half_;
  Eigen::Vector2d mean_squares_;
};

}  // namespace scan_calibration
