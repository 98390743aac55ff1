// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/board_view.h"
#include "scan_calibration/calibration.h"

namespace scan_calibration {

/// What a fit may move.
struct FitChoice {
  bool robot = true;           //!< false: the camera alone; every view's pose is free, nothing else
  bool camera = true;          //!< false: camera and its pose on the flange are known
  bool bend = false;           //!< whether the board may be bent
  bool square_pixels = false;  //!< fx = fy
};

/// Moves the state to where the weighted squares are least, at the given noise and weights.
/// @throw scan_cell_common::UnusableInput if there is no way down from the state given
void fit(const BoardViews& views, const BoardSurface& surface, const NoiseLevels& noise,
         const FitChoice& choice, ScannerState& state);

/// Corners, and a laser's points, that are worth one (multiplicity.h).
struct Multiplicities {
  double corners = 1;
  std::vector<double> lines;
};

/// Weights of corners, points and poses by how far they miss, as of Huber's function: one within
/// three deviations, falling beyond; corners and points beyond eight are left out. Those of corners
/// and points are divided by how many are worth one.
void weigh(const ScannerState& state, const BoardSurface& surface, const NoiseLevels& noise,
           const Multiplicities& multiplicities, BoardViews& views);

}  // namespace scan_calibration
