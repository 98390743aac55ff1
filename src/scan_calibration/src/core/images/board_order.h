// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "images/board_detection.h"

namespace scan_calibration {

/// The corners of one board, counted from another of its corners so that the board looks the same:
/// turned by quarters about its normal.
BoardCorners turned(const BoardCorners& corners, const Board& board, int quarters);

/// By how many quarters a board can be turned and look the same in shape and colour: 0 always.
std::vector<int> symmetries(const Board& board);

/// Puts corners that were counted from any corner, in any sense, into the order of find_board().
/// @param corners all of them finite
/// @param image where they were seen
BoardCorners in_order(BoardCorners corners, const Board& board, const cv::Mat& image);

/// A view whose corners may be counted from several ends of the board.
struct TurnableView {
  Eigen::Matrix3d flange_in_base;   //!< rotation, from the robot
  Eigen::Matrix3d board_in_camera;  //!< rotation, from the corners as they are counted now
};

/// By how many quarters to turn each view's corners so that all are counted from the same end. The
/// angle between two orientations of the flange is that between the camera's, wherever on the
/// flange it is (the angles of A and B in A X = X B are the same): each view takes the symmetry
/// that suits all others best, in turn, until none changes. The end itself is that of the first.
std::vector<int> align_corners(const std::vector<TurnableView>& views, const Board& board);

}  // namespace scan_calibration
