// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/board_view.h"
#include "scan_calibration/calibration.h"

namespace scan_calibration {

/// A view judged by a model: the board's pose fitted to its corners, then all that follows.
struct JudgedView {
  Eigen::Isometry3d camera_to_board = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector2d> corner_residuals;     //!< [px] seen - modelled
  std::vector<std::vector<double>> plane_distances;  //!< [m] a laser, a point; NaN: left out
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  //!< [m] of the board in base_link
  double corner_squares = 0, corner_count = 0;       //!< [px^2] of those not left out
  std::vector<double> plane_squares, plane_counts;   //!< [m^2] a laser

  ViewFigures figures(const BoardView& view, const ScannerState& state,
                      const BoardSurface& surface) const;
};

/// @throw scan_cell_common::UnusableInput if the model cannot show the view
JudgedView judge(const ScannerState& state, const BoardSurface& surface, const BoardView& view);

/// Adds up judged views.
class FigureSums {
 public:
  explicit FigureSums(std::size_t lasers) : plane_squares_(lasers), plane_counts_(lasers) {}

  /// @param offset [m] of the board's centre from where it is expected
  void add(const JudgedView& view, const Eigen::Vector3d& offset);
  void add(const FigureSums& others);
  Figures figures() const;

 private:
  double corner_squares_ = 0, corner_count_ = 0, offset_squares_ = 0, views_ = 0;
  std::vector<double> plane_squares_, plane_counts_;
};

/// Of the views that a model was fitted to: the board's centre about its mean.
Figures fitted_figures(const std::vector<JudgedView>& views, std::size_t lasers);

/// [m] of the board in base_link, as the model has it.
Eigen::Vector3d board_centre(const ScannerState& state, const BoardSurface& surface);

/// Group that each of `count` views is held out with: in turn, so that each group is spread over
/// the session.
std::vector<std::size_t> fold_of_each(std::size_t count, int folds);

}  // namespace scan_calibration
