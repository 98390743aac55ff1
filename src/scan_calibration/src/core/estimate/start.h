// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "checks/diagnosis.h"
#include "checks/session_checks.h"
#include "estimate/camera_fit.h"

namespace scan_calibration {

/// Where the joint estimate starts.
struct Start {
  BoardViews views;
  ScannerState state;  //!< with the corrections that each view's corners alone give
  NoiseLevels noise;   //!< robust
  std::vector<RejectedView> rejected;
  std::string note;  //!< how well a kept camera fits; empty: none is kept
};

/// Camera, hand-eye, board and laser planes, one after the other, in closed form and robust. A kept
/// camera stays as it is, with its pose on the flange.
/// @throw scan_cell_common::UnusableInput as calibrate()
Start closed_form_start(const Observations& observations, const CalibrationOptions& options);

/// Leaves out views whose corners fit the camera far worse than those of the others, and refits.
/// @param fit finds the camera of views
CameraFit fit_and_reject(BoardViews& views, const BoardSurface& surface,
                         const std::function<CameraFit(BoardViews&)>& fit,
                         std::vector<RejectedView>& rejected);

}  // namespace scan_calibration
