// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "checks/diagnosis.h"
#include "checks/session_checks.h"
#include "estimate/camera_fit.h"

namespace scan_calibration {

/// Where the joint estimate begins.
struct Start {
  BoardViews views;
  ScannerState state;  //!< its corrections are what each view's corners alone would have
  NoiseLevels noise;   //!< by robust measures
  std::vector<RejectedView> rejected;
  std::string note;  //!< how well a camera that is kept fits; empty: none is
};

/// Camera alone, hand-eye, board and laser planes one after the other, in closed form and robustly;
/// a camera that is kept with its place on the flange, as they are.
/// @throw scan_cell_common::UnusableInput as calibrate()
Start closed_form_start(const Observations& observations, const CalibrationOptions& options);

/// Leaves out views whose corners fit the camera far worse than the others' do, and fits again.
/// @param fit gives the camera of views
CameraFit fit_and_reject(BoardViews& views, const BoardSurface& surface,
                         const std::function<CameraFit(BoardViews&)>& fit,
                         std::vector<RejectedView>& rejected);

}  // namespace scan_calibration
