// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "laser_lines/line_peaks.h"
#include "scan_calibration/observations.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_calibration {

/// A laser's line on the board's plane.
struct BoardLine {
  std::vector<Eigen::Vector2d> pixels;  //!< empty: there is none
  std::vector<Eigen::Vector2d> course;  //!< [px] the same with the peaks left out of it
  double width = 0;                     //!< [px] median of the stripe's
  LineCounts counts;
  std::string reason;  //!< why there is none
};

/// The peaks on the board's plane. As the board is flat and the light is a plane, they lie on one
/// straight line (without the lens's distortion). It is the line with the most peaks; peaks on the
/// checker count several times, so that a longer line on the table beside the board does not win.
/// Peaks beside the checker on the same line are kept, too: the board's plate continues there.
/// @param ways of going through the image; the one that crosses the line steeply is used
/// @param camera rough
/// @param board_in_camera rough
BoardLine board_line(const std::vector<LinePeaks>& ways,
                     const scan_cell_common::CameraIntrinsics& camera,
                     const Eigen::Isometry3d& board_in_camera, const Board& board, int max_points);

}  // namespace scan_calibration
