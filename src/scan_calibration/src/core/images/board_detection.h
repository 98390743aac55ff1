// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "scan_calibration/session.h"

namespace scan_calibration {

/// The columns * rows inner corners of a board [px], row by row as in Board; NaN where a corner is
/// covered. Empty: the board is not seen.
using BoardCorners = std::vector<Eigen::Vector2d>;

/// Finds the board in an image of 8 or 16 bit grey pixels, also if it is dark or faint or lies
/// beside a saturated line. The corners are found by OpenCV's sector method (Duda and Frese 2018)
/// and then fitted (corner_refinement.h).
///
/// The order is that of a board seen from the front. If the board's colours tell its directions
/// apart (columns + rows odd), the square between the first two corners of the first two rows is
/// bright; if they do not, the order may differ from image to image: see align_corners().
BoardCorners find_board(const cv::Mat& image, const Board& board);

/// Columns and rows of inner corners of any checkerboard in an image, the greater first; {0, 0} if
/// there is none. It is meant to detect a wrong board size; a single image may mislead.
std::pair<int, int> size_of_any_board(const cv::Mat& image);

}  // namespace scan_calibration
