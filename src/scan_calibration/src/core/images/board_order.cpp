// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "images/board_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace scan_calibration {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;

double grey_at(const cv::Mat& image, const Vector2d& pixel) {
  const int column = std::clamp(static_cast<int>(std::lround(pixel.x())), 0, image.cols - 1);
  const int row = std::clamp(static_cast<int>(std::lround(pixel.y())), 0, image.rows - 1);
  return image.depth() == CV_16U ? image.at<std::uint16_t>(row, column)
                                 : image.at<std::uint8_t>(row, column);
}

/// Whether the square between the first two corners of the first two rows is bright. All squares
/// vote.
bool begins_bright(const BoardCorners& corners, const Board& board, const cv::Mat& image) {
  double bright = 0;
  for (int row = 0; row + 1 < board.rows; ++row) {
    for (int column = 0; column + 1 < board.columns; ++column) {
      const std::size_t first = row * board.columns + column;
      const Vector2d middle =
          0.25 * (corners[first] + corners[first + 1] + corners[first + board.columns] +
                  corners[first + board.columns + 1]);
      // The root: a laser line over some squares must not outvote the rest
      bright += ((row + column) % 2 == 0 ? 1 : -1) * std::sqrt(grey_at(image, middle));
    }
  }
  const int squares = (board.rows - 1) * (board.columns - 1);
  if (squares % 2 == 0) return bright > 0;
  double mean = 0;  // one more square of the first colour than of the other
  for (const Vector2d& corner : corners)
    mean += std::sqrt(grey_at(image, corner)) / static_cast<double>(corners.size());
  return bright > mean;
}

double angle_of(const Matrix3d& rotation) {
  return Eigen::AngleAxisd(rotation).angle();
}

/// Pose of the board, whose axes turn with the corner that is listed first.
Matrix3d pose(const TurnableView& view, int quarters) {
  return view.board_in_camera *
         Eigen::AngleAxisd(quarters * M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

/// The choice for a view that best suits the first `others` views.
int best_turn(const std::vector<TurnableView>& views, const std::vector<int>& choices,
              const std::vector<int>& quarters, std::size_t view, std::size_t others) {
  constexpr double kMaxMismatch = 0.3;  // [rad] chosen: more means that a pose is wrong
  constexpr double kSame = 1e-9;        // [rad] rounding
  double least = std::numeric_limits<double>::infinity();
  int best = quarters[view];
  for (const int turns : choices) {
    double mismatch = 0;
    for (std::size_t other = 0; other < others; ++other) {
      if (other == view) continue;
      const double by_robot =
          angle_of(views[view].flange_in_base.transpose() * views[other].flange_in_base);
      const double by_camera =
          angle_of(pose(views[view], turns) * pose(views[other], quarters[other]).transpose());
      mismatch += std::min(kMaxMismatch, std::abs(by_robot - by_camera));
    }
    if (mismatch >= least - kSame) continue;
    least = mismatch;
    best = turns;
  }
  return best;
}

}  // namespace

BoardCorners turned(const BoardCorners& corners, const Board& board, int quarters) {
  BoardCorners result = corners;
  if (quarters % 2 != 0) {  // only of a square board
    const int side = board.columns;
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column)
        result[row * side + column] = corners[column * side + side - 1 - row];
  }
  if (quarters >= 2) std::reverse(result.begin(), result.end());
  return result;
}

std::vector<int> symmetries(const Board& board) {
  if ((board.columns + board.rows) % 2 != 0) return {0};
  if (board.columns == board.rows && board.columns % 2 == 0) return {0, 1, 2, 3};
  return {0, 2};
}

BoardCorners in_order(BoardCorners corners, const Board& board, const cv::Mat& image) {
  const Vector2d along_columns = corners[board.columns - 1] - corners.front();
  const Vector2d along_rows = corners[(board.rows - 1) * board.columns] - corners.front();
  if (along_columns.x() * along_rows.y() < along_columns.y() * along_rows.x()) {
    for (auto row = corners.begin(); row != corners.end(); row += board.columns)
      std::reverse(row, row + board.columns);
  }
  if (begins_bright(corners, board, image)) return corners;
  if ((board.columns + board.rows) % 2 != 0) return turned(corners, board, 2);
  if (board.columns == board.rows && board.columns % 2 != 0) return turned(corners, board, 1);
  return corners;  // the first square is dark from both ends
}

std::vector<int> align_corners(const std::vector<TurnableView>& views, const Board& board) {
  constexpr int kMaxRounds = 10;  // chosen: two are usual
  const std::vector<int> choices = symmetries(board);
  std::vector<int> quarters(views.size(), 0);
  for (std::size_t view = 1; view < views.size(); ++view)
    quarters[view] = best_turn(views, choices, quarters, view, view);
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<int> before = quarters;
    for (std::size_t view = 1; view < views.size(); ++view)
      quarters[view] = best_turn(views, choices, quarters, view, views.size());
    if (quarters == before) break;
  }
  return quarters;
}

}  // namespace scan_calibration
