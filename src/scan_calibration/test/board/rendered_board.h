// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "scan_calibration/session.h"
#include "scan_cell_common/scanner/scanner_model.h"

/// Images of a checkerboard on a plate above a table, through a known camera: the ground truth for
/// the readers of images. It shares only the lens model with the code that it judges.
struct RenderedScene {
  scan_calibration::Board board;
  double plate_margin = 0.03;  //!< [m] by which the white plate is larger than the checker
  double plate_height = 0.01;  //!< [m] above the table
  double white = 200;          //!< [grey value] of the board under the room's light
  double black = 30;
  double table = 60;
  double blur = 0.7;         //!< [px] standard deviation of the lens's spot
  double noise = 2;          //!< [grey value] standard deviation of a pixel
  double room_light = 1;     //!< 0: only the laser shows
  double laser_light = 0;    //!< [grey value] of the line's middle on white; 0: laser off
  double line_sigma = 5e-4;  //!< [m] of the line's profile across its plane
  scan_cell_common::LaserPlane laser;
};

class BoardRenderer {
 public:
  /// @param samples of a pixel, squared
  explicit BoardRenderer(const scan_cell_common::CameraIntrinsics& camera, int samples = 4);

  /// @param board_in_camera pose of the board (docs of Board) in camera_optical_frame
  cv::Mat render(const RenderedScene& scene, const Eigen::Isometry3d& board_in_camera,
                 std::uint32_t seed) const;

  const scan_cell_common::CameraIntrinsics& camera() const { return camera_; }

 private:
  scan_cell_common::CameraIntrinsics camera_;
  int samples_;
  std::vector<Eigen::Vector2f> rays_;  // of the samples, pixel by pixel
};

/// Pose of a board in camera_optical_frame whose centre lies at `centre`, tilted by `tilt` about
/// the direction `towards` in its plane and turned by `turn` about its normal [rad].
Eigen::Isometry3d board_pose(const scan_calibration::Board& board, const Eigen::Vector3d& centre,
                             double tilt, double towards, double turn);

/// The true place of an inner corner [px].
Eigen::Vector2d true_corner(const scan_cell_common::CameraIntrinsics& camera,
                            const Eigen::Isometry3d& board_in_camera,
                            const scan_calibration::Board& board, int column, int row);
