// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scan_calibration/calibration.h"
#include "scan_cell_common/scanner_model.h"

namespace scan_calibration {

/// What is known of the camera beforehand.
struct CameraOptions {
  bool square_pixels = false;  //!< fx = fy
  bool reject_views = true;    //!< false: every view is used, and each corner counts alike
};

/// A camera calibrated from views of the board alone.
struct CameraCalibration {
  scan_cell_common::CameraIntrinsics camera;
  std::vector<EstimatedParameter> parameters;  //!< camera.fx ...
  double reprojection_rms_px = 0;              //!< over the corners of the used views
  std::vector<ViewFigures> views;              //!< used ones; only what the camera alone can tell
  std::vector<RejectedView> rejected;
};

/// Intrinsics with a free board pose a view (Zhang 2000); what is known of the robot is not used.
/// @throw scan_cell_common::UnusableInput if the views are too few, or too alike to tell the focal
/// length from the distance
CameraCalibration calibrate_camera(const Observations& observations, const CameraOptions& options);

}  // namespace scan_calibration
