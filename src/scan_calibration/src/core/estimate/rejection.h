// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "residuals/normal_equations.h"

namespace scan_calibration {

/// Leaves out views, and lines in views, that miss the estimate by more than noise would: corners
/// or lines that miss far more than those of the other views, poses beyond what one in a hundred
/// thousand would by the noise of the other poses. Each is added to `rejected` with its reason.
/// @return whether anything was left out
/// @throw scan_cell_common::UnusableInput if too little would be left
bool reject_misfits(const BoardSurface& surface, const NoiseLevels& noise,
                    const NormalEquations& equations, const std::vector<std::string>& lasers,
                    BoardViews& views, ScannerState& state, std::vector<RejectedView>& rejected);

}  // namespace scan_calibration
