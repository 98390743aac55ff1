// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "scan_calibration/calibration.h"

namespace scan_calibration {

/// The step-by-step method, as a yardstick for calibrate(): OpenCV's intrinsics with a free board
/// pose per view, Park's hand-eye on those poses, and each laser plane by total least squares
/// through its points on those boards. It rejects no view: pass the views that calibrate() used
/// (used_views()), so that both are judged on the same views in the same folds.
/// @param known supplies camera and flange_to_camera if they are not calibrated again
/// @throw scan_cell_common::UnusableInput if there are fewer than three views
SequentialCalibration calibrate_sequentially(
    const Observations& observations, int folds,
    const std::optional<scan_cell_common::ScannerModel>& known = std::nullopt);

/// The views and lines that a calibration used.
Observations used_views(const Observations& observations, const Calibration& calibration);

}  // namespace scan_calibration
