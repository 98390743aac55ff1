// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/board_view.h"

namespace scan_calibration {

/// Neighbours with correlated errors carry less information than their number suggests: a bent
/// board or blur moves them together. These functions return how many corners, or points of a line,
/// count as one independent observation. They use the correlation of direct neighbours' residuals
/// (its lower bound of two standard deviations), which is assumed to decay exponentially with
/// distance. The result is 1 if there is no correlation.
double corner_multiplicity(const ScannerState& state, const BoardSurface& surface,
                           const Board& board, const BoardViews& views);

double line_multiplicity(const ScannerState& state, const BoardSurface& surface,
                         const BoardViews& views, std::size_t laser);

}  // namespace scan_calibration
