// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "geometry/scanner_state.h"
#include "geometry/sight.h"
#include "scan_calibration/observations.h"

namespace scan_calibration {

/// A laser's points in a view, thinned.
struct LinePoints {
  std::vector<Eigen::Vector2d> pixels;
  std::vector<std::size_t> index;  //!< of each in the observation
  std::vector<double> weights;     //!< 0 (left out) .. 1
};

/// A view as the estimate uses it.
struct BoardView {
  std::string name;
  std::size_t source = 0;               //!< index into Observations::views
  Eigen::Isometry3d measured;           //!< base_to_flange [m]
  std::vector<Eigen::Vector2d> places;  //!< [m] of the seen corners on the board
  std::vector<Eigen::Vector2d> pixels;
  std::vector<double> weights;  //!< 0 (left out) .. 1
  double pose_weight = 1;       //!< of the measured pose, 0 .. 1
  std::vector<LinePoints> lines;
};

using BoardViews = std::vector<BoardView>;

/// Makes a view of an observation. Long lines are thinned evenly: neighbouring points share the
/// errors of the board's surface and of the laser's speckle, so all of them would carry less
/// information than their number suggests.
BoardView board_view(const Observations& observations, std::size_t index);

/// Renames the corners' places if they were listed from the board's other end.
void turn_half(BoardView& view, const BoardSurface& surface);

/// The board in the camera, from the corrected pose of the robot.
BoardSight sight_of(const ScannerState& state, const BoardView& view, std::size_t index);

/// Observed - modelled [px]; NaN for a corner behind the camera.
std::vector<Eigen::Vector2d> corner_residuals(const ScannerState& state,
                                              const BoardSurface& surface, const BoardSight& sight,
                                              const BoardView& view);

/// [px] across the line; NaN where the lens model cannot be inverted.
std::vector<double> line_residuals(const ScannerState& state, const BoardSurface& surface,
                                   const BoardSight& sight, const LinePoints& line,
                                   std::size_t laser);

}  // namespace scan_calibration
