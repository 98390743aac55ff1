// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/board_view.h"

namespace scan_calibration {

/// Neighbours that miss alike say less than their number: what bends the board or blurs the image
/// moves them together. How many corners, or points of a line, are worth one that is off on its
/// own. Both follow from the correlation of direct neighbours' residuals, less two deviations of
/// it, taken to fall off exponentially with distance; 1 where there is none.
double corner_multiplicity(const ScannerState& state, const BoardSurface& surface,
                           const Board& board, const BoardViews& views);

double line_multiplicity(const ScannerState& state, const BoardSurface& surface,
                         const BoardViews& views, std::size_t laser);

}  // namespace scan_calibration
