// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "geometry/scanner_state.h"

namespace scan_calibration {

/// The board's pose in the camera, and its derivatives.
struct BoardSight {
  Eigen::Matrix3d rotation;  //!< of the board in camera_optical_frame
  Eigen::Vector3d position;  //!< [m]
  /// Rows: turn about and shift along the camera's axes. Columns: motions of flange_to_camera, of
  /// base_to_board and of the flange, six each.
  Eigen::Matrix<double, 6, 18> by_motions;
};

/// @param camera_motion, board_motion, flange_motion from the given poses; the derivative is taken
/// at these motions
BoardSight board_sight(const Eigen::Isometry3d& flange_to_camera,
                       const Eigen::Isometry3d& base_to_board,
                       const Eigen::Isometry3d& base_to_flange, const Vector6d& camera_motion,
                       const Vector6d& board_motion, const Vector6d& flange_motion);

/// The same for a measured pose of the board in the camera, without derivatives.
BoardSight board_sight(const Eigen::Isometry3d& camera_to_board);

/// A point's image.
struct Projection {
  Eigen::Vector2d pixel;
  Eigen::Matrix<double, 2, 3> by_point;
  Eigen::Matrix<double, 2, 9> by_camera;
};

/// @param point [m] in camera_optical_frame
/// @return false if it is not in front of the camera
bool project(const CameraVector& camera, const Eigen::Vector3d& point, Projection& result);

/// The ray (x/z, y/z, 1) in camera_optical_frame that a pixel sees; none if the lens model cannot
/// be inverted there.
inline std::optional<Eigen::Vector3d> ray_of(const scan_cell_common::CameraIntrinsics& camera,
                                             const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d distorted((pixel.x() - camera.cx) / camera.fx,
                                  (pixel.y() - camera.cy) / camera.fy);
  Eigen::Vector2d ray = distorted;
  if (!camera.undistort(distorted, ray)) return std::nullopt;
  return ray.homogeneous();
}

/// The distance from a laser's plane of the point that a pixel sees on the board.
struct LineOffset {
  /// [m] on the board, in camera_optical_frame
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double value = 0;                                    //!< plane . point - 1
  Eigen::Vector2d by_pixel = Eigen::Vector2d::Zero();  //!< [1/px]
  CameraVector by_camera = CameraVector::Zero();
  Vector6d by_sight = Vector6d::Zero();  //!< turn and shift of the board
  Eigen::Vector3d by_bend = Eigen::Vector3d::Zero();

  /// [px] across the line, to first order (Sampson 1982)
  double pixels() const { return value / by_pixel.norm(); }
};

/// The derivatives are exact: the implicit function theorem gives those of the lens's inverse and
/// of the intersection with the bent board.
/// @return false if the lens model cannot be inverted there, or the ray does not meet the board
bool line_offset(const ScannerState& scanner, const BoardSurface& surface, const BoardSight& sight,
                 const Eigen::Vector2d& pixel, const Eigen::Vector3d& plane, LineOffset& result);

/// Position of a corner of the board.
/// @param place [m] on the board
Eigen::Vector3d on_board(const BoardSurface& surface, const Eigen::Vector3d& bend,
                         const Eigen::Vector2d& place);

}  // namespace scan_calibration
