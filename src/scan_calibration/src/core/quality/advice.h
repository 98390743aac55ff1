// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quality/point_uncertainty.h"

namespace scan_calibration {

/// Poses to add, best first: of possible views of the whole board at various distances, tilts and
/// places in the image, those whose information most reduces the uncertainty of `places`, each
/// different from the previous ones.
std::vector<PoseAdvice> advise(const JointEstimate& estimate, const Knowledge& knowledge,
                               const Board& board, const std::vector<ScanPlace>& places);

}  // namespace scan_calibration
