// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "scan_calibration/session.h"

namespace scan_calibration {

/// Inner corners of a board [px], row by row as in Board: columns * rows of them, NaN where a
/// corner is covered. Empty: the board is not seen.
using BoardCorners = std::vector<Eigen::Vector2d>;

/// Finds the board in an image of 8 or 16 bit grey pixels: dark, faint, or with a saturated line
/// beside it. The corners are found by OpenCV's sector method (Duda and Frese 2018) and then fitted
/// (corner_refinement.h).
///
/// The order is that of a board seen from the front. Where the board's colours tell its directions
/// apart (columns + rows odd), the square between the first two corners of the first two rows is
/// bright; where they do not, the order may differ from image to image: align_corners().
BoardCorners find_board(const cv::Mat& image, const Board& board);

/// Columns and rows of inner corners of whatever checkerboard is in an image, the greater first;
/// {0, 0} where none is. To tell a wrong board size, and as sure as one image can be.
std::pair<int, int> size_of_any_board(const cv::Mat& image);

}  // namespace scan_calibration
