// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quality/point_uncertainty.h"

namespace scan_calibration {

/// Poses to add, best first: of views of the whole board at the distances, tilts and places in the
/// image that a camera may have, the ones whose information lessens the uncertainty of `places`
/// most, each differing from those before it.
std::vector<PoseAdvice> advise(const JointEstimate& estimate, const Knowledge& knowledge,
                               const Board& board, const std::vector<ScanPlace>& places);

}  // namespace scan_calibration
