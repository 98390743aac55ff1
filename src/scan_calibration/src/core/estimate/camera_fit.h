// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "residuals/joint_fit.h"

namespace scan_calibration {

/// A camera alone: intrinsics, and the board's pose in each view.
struct CameraFit {
  ScannerState state;  //!< only its camera counts
  std::vector<Eigen::Isometry3d> camera_to_board;
  std::vector<double> rms_px;  //!< a view
  double corner_px = 0;        //!< robust standard deviation along each axis
};

/// A fit from Zhang's closed form and the perspective pose of each view, then by least squares.
/// @param views their corners are reweighted if `robust`
/// @throw scan_cell_common::UnusableInput if no camera explains the views
CameraFit fit_camera(BoardViews& views, const BoardSurface& surface, int width, int height,
                     bool square_pixels, bool robust);

/// The same, robustly, from a camera that is known or nearly right.
/// @param views their corners are reweighted
/// @param keep whether the camera stays as it is
/// @throw scan_cell_common::UnusableInput if it cannot explain the views
CameraFit fit_near(BoardViews& views, const BoardSurface& surface,
                   const scan_cell_common::CameraIntrinsics& camera, bool keep);

/// RMS [px] of the residuals that have a weight.
double rms_of(const std::vector<Eigen::Vector2d>& residuals, const std::vector<double>& weights);

}  // namespace scan_calibration
