// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimate/start.h"
#include "residuals/noise_components.h"

namespace scan_calibration {

/// Views, what they were found to say, and how sure that is.
struct JointEstimate {
  BoardViews views;
  ScannerState state;
  NoiseEstimate noise;
  Multiplicities multiplicities;
  FitChoice choice;
  std::vector<RejectedView> rejected;
};

/// From a start to the least squares of everything together: in turn the fit, the noise, the
/// weights, and what does not fit left out, until nothing changes.
/// @throw scan_cell_common::UnusableInput if the views do not agree with one another
JointEstimate estimate_jointly(Start start, const Observations& observations,
                               const CalibrationOptions& options, const FitChoice& choice);

/// The same model without some views, from where it stands; noise and weights stay.
/// @param keep a view of the estimate
JointEstimate without(const JointEstimate& estimate, const BoardSurface& surface,
                      const std::vector<bool>& keep);

}  // namespace scan_calibration
