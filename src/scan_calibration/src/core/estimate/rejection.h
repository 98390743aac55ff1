// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "residuals/normal_equations.h"

namespace scan_calibration {

/// Per view: why its corners miss far more than those of the others, outliers included; empty: they
/// do not.
/// @param sights where the camera has the board, per view
std::vector<std::string> misfit_corners(const ScannerState& state, const BoardSurface& surface,
                                        const std::vector<BoardSight>& sights,
                                        const BoardViews& views);

/// Leaves out views, and lines of views, that miss the estimate by more than noise explains:
/// corners or lines that miss far more than those of the other views, and poses that are less
/// likely than one in a hundred thousand, given the noise of the other poses. Adds each to
/// `rejected` with its reason.
/// @return whether anything was left out
/// @throw scan_cell_common::UnusableInput if too little would be left
bool reject_misfits(const BoardSurface& surface, const NoiseLevels& noise,
                    const NormalEquations& equations, const std::vector<std::string>& lasers,
                    BoardViews& views, ScannerState& state, std::vector<RejectedView>& rejected);

}  // namespace scan_calibration
