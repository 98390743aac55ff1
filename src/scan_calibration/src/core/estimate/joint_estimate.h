// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimate/start.h"
#include "residuals/noise_components.h"

namespace scan_calibration {

/// Views, the model fitted to them, and its noise.
struct JointEstimate {
  BoardViews views;
  ScannerState state;
  NoiseEstimate noise;
  Multiplicities multiplicities;
  FitChoice choice;
  std::vector<RejectedView> rejected;
};

/// Iterates fit, noise, weights and the rejection of what does not fit until nothing changes.
/// @throw scan_cell_common::UnusableInput if the views contradict one another
JointEstimate estimate_jointly(Start start, const Observations& observations,
                               const CalibrationOptions& options, const FitChoice& choice);

/// The model refitted without some views, with the same noise and weights.
/// @param keep per view of the estimate
JointEstimate without(const JointEstimate& estimate, const BoardSurface& surface,
                      const std::vector<bool>& keep);

}  // namespace scan_calibration
