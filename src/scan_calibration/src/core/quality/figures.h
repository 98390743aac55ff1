// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "geometry/board_view.h"
#include "geometry/statistics.h"
#include "scan_calibration/calibration.h"

namespace scan_calibration {

/// A view compared with a model: the board's pose fitted to its corners, then all that follows.
struct JudgedView {
  Eigen::Isometry3d camera_to_board = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector2d> corner_residuals;     //!< [px] observed - modelled
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  //!< [m] of the board in base_link
  SquareSum corners;                                 //!< [px^2] without outliers
  std::vector<SquareSum> planes;                     //!< [m^2] per laser, without outliers

  ViewFigures figures(const BoardView& view, const ScannerState& state,
                      const BoardSurface& surface) const;
};

/// @throw scan_cell_common::UnusableInput if the model cannot show a view
std::vector<JudgedView> judge(const ScannerState& state, const BoardSurface& surface,
                              const BoardViews& views);

/// Figures of the views that a model was fitted to; the board's centre is compared with its mean.
Figures fitted_figures(const std::vector<JudgedView>& views, std::size_t lasers);

/// Figures of views that are held out in turn, in groups spread over the session; the board's
/// centre is compared with the model's.
/// @param fitted returns the model fitted to the views to keep
Figures held_out_figures(const BoardViews& views, const BoardSurface& surface, std::size_t lasers,
                         int folds, int threads,
                         const std::function<ScannerState(const std::vector<bool>&)>& fitted);

}  // namespace scan_calibration
