// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scan_calibration/calibration.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_calibration {

/// What is known of the camera in advance.
struct CameraOptions {
  bool square_pixels = false;  //!< fx = fy
  bool reject_views = true;    //!< false: use every view, every corner with the same weight
};

/// A camera calibrated from views of the board alone.
struct CameraCalibration {
  scan_cell_common::CameraIntrinsics camera;
  std::vector<EstimatedParameter> parameters;  //!< camera.fx ...
  double reprojection_rms_px = 0;              //!< over the corners of the used views
  std::vector<ViewFigures> views;              //!< those used; only figures of the camera
  std::vector<RejectedView> rejected;
};

/// Intrinsics with a free board pose per view (Zhang 2000), without the robot's poses.
/// @throw scan_cell_common::UnusableInput if the views are too few, or too alike to separate focal
/// length and distance
CameraCalibration calibrate_camera(const Observations& observations, const CameraOptions& options);

}  // namespace scan_calibration
