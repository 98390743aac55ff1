// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "images/board_detection.h"

namespace scan_calibration {

/// The corners of one board, listed from another of its corners: turned by quarters about its
/// normal.
BoardCorners turned(const BoardCorners& corners, const Board& board, int quarters);

/// The quarter turns that leave a board the same in shape and colour. 0 is always among them.
std::vector<int> symmetries(const Board& board);

/// Puts corners that are listed from any corner, in any sense, into the order of find_board().
/// @param corners all of them finite
/// @param image that shows them
BoardCorners in_order(BoardCorners corners, const Board& board, const cv::Mat& image);

/// A view whose corners may be listed from several ends of the board.
struct TurnableView {
  Eigen::Matrix3d flange_in_base;   //!< rotation, from the robot
  Eigen::Matrix3d board_in_camera;  //!< rotation, from the corners as they are listed now
};

/// By how many quarters to turn each view's corners so that all are listed from the same end. The
/// angle between two orientations of the flange equals that between the camera's, wherever the
/// camera sits on the flange (A and B in A X = X B have the same angle). Each view in turn takes
/// the symmetry that best suits all others, until none changes. The end is that of the first view.
std::vector<int> align_corners(const std::vector<TurnableView>& views, const Board& board);

}  // namespace scan_calibration
