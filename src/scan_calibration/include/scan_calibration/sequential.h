// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "scan_calibration/calibration.h"

namespace scan_calibration {

/// A scanner calibrated one step after the other.
struct SequentialCalibration {
  scan_cell_common::ScannerModel scanner;
  Eigen::Isometry3d base_to_board;  //!< [m] mean over the views
  Figures fitted;
  Figures held_out;
};

/// The plain way, as a yardstick beside calibrate(): OpenCV's intrinsics with a free board pose a
/// view, Park's hand-eye on those poses, each laser plane through its points on those boards. No
/// view is rejected: give it those that calibrate() used (used_views()), so that both are judged by
/// the same views in the same folds.
/// @param known camera and its pose on the flange, where they are not calibrated anew
/// @throw scan_cell_common::UnusableInput if there are fewer than three views
SequentialCalibration calibrate_sequentially(
    const Observations& observations, int folds,
    const std::optional<scan_cell_common::ScannerModel>& known = std::nullopt);

/// The views and lines that a calibration used.
Observations used_views(const Observations& observations, const Calibration& calibration);

}  // namespace scan_calibration
