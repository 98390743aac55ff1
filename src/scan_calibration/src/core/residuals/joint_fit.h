// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/board_view.h"
#include "scan_calibration/calibration.h"

namespace scan_calibration {

/// What a fit may move.
struct FitChoice {
  bool robot = true;           //!< false: camera alone; besides it only each view's pose is free
  bool camera = true;          //!< false: camera and its pose on the flange are known
  bool bend = false;           //!< whether the board may be bent
  bool square_pixels = false;  //!< fx = fy
};

/// Moves the state to the minimum of the weighted squares, with the given noise and weights.
/// @throw scan_cell_common::UnusableInput if the solver fails from the given state
void fit(const BoardViews& views, const BoardSurface& surface, const NoiseLevels& noise,
         const FitChoice& choice, ScannerState& state);

/// How many corners, or points of each laser, count as one (multiplicity.h).
struct Multiplicities {
  double corners = 1;
  std::vector<double> lines;
};

/// Huber weights of corners, points and poses: 1 within three standard deviations, falling beyond.
/// Corners and points beyond eight are outliers (weight 0). Weights of corners and points are
/// divided by the number that counts as one.
void weigh(const ScannerState& state, const BoardSurface& surface, const NoiseLevels& noise,
           const Multiplicities& multiplicities, BoardViews& views);

}  // namespace scan_calibration
