// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "images/board_detection.h"

#include <algorithm>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "images/board_order.h"
#include "images/corner_refinement.h"

namespace scan_calibration {
namespace {

using Eigen::Vector2d;

/// Stretches the grey values between two quantiles to 8 bits: beside a laser line a board is dark,
/// and the line's own light says nothing about it.
cv::Mat stretched(const cv::Mat& image, double dark_share, double bright_share) {
  const double range = image.depth() == CV_16U ? 65536 : 256;
  const int bins = image.depth() == CV_16U ? 4096 : 256;
  const float limits[] = {0, static_cast<float>(range)};
  const float* limits_of_all[] = {limits};
  const int channel = 0;
  cv::Mat histogram;
  cv::calcHist(&image, 1, &channel, cv::Mat(), histogram, 1, &bins, limits_of_all);
  const auto quantile = [&](double share) {
    double sum = 0;
    for (int bin = 0; bin < bins; ++bin) {
      sum += histogram.at<float>(bin);
      if (sum >= share * static_cast<double>(image.total())) return bin * range / bins;
    }
    return range;
  };
  const double dark = quantile(dark_share);
  const double bright = std::max(quantile(bright_share), dark + 2 * range / bins);
  cv::Mat result;
  image.convertTo(result, CV_8U, 255 / (bright - dark), -255 * dark / (bright - dark));
  return result;
}

constexpr double kReducedSide = 1000;                  // [px] chosen: faster, and with less noise
constexpr double kDarkShare = 0.01;                    // of the pixels become black, chosen
constexpr double kBrightShares[] = {0.75, 0.9, 0.99};  // of the pixels stay below white, chosen

std::vector<cv::Point2f> find_roughly(const cv::Mat& image, const cv::Size& size) {
  const double scale = std::min(1.0, kReducedSide / std::max(image.cols, image.rows));
  for (const bool reduced : {true, false}) {
    if (reduced && scale == 1) continue;
    for (const double bright_share : kBrightShares) {
      cv::Mat seen = stretched(image, kDarkShare, bright_share);
      const double factor = reduced ? scale : 1;
      if (reduced) cv::resize(seen, seen, cv::Size(), factor, factor, cv::INTER_AREA);
      std::vector<cv::Point2f> corners;
      if (!cv::findChessboardCornersSB(seen, size, corners, 0)) continue;
      for (cv::Point2f& corner : corners) {
        corner.x = static_cast<float>((corner.x + 0.5) / factor - 0.5);
        corner.y = static_cast<float>((corner.y + 0.5) / factor - 0.5);
      }
      return corners;
    }
  }
  return {};
}

/// Step from one corner to its neighbour along a line of `count` corners, about `index`.
Vector2d step(const BoardCorners& corners, int first, int stride, int index, int count) {
  const int before = std::max(index - 1, 0), after = std::min(index + 1, count - 1);
  return (corners[first + after * stride] - corners[first + before * stride]) / (after - before);
}

BoardCorners refined(const cv::Mat& image, const BoardCorners& rough, const Board& board) {
  cv::Mat grey;
  image.convertTo(grey, CV_32F);
  BoardCorners result;
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      RoughCorner corner{rough[row * board.columns + column],
                         step(rough, row * board.columns, 1, column, board.columns),
                         step(rough, column, board.columns, row, board.rows)};
      if (!refine_corner(grey, corner))
        corner.pixel.setConstant(std::numeric_limits<double>::quiet_NaN());
      result.push_back(corner.pixel);
    }
  }
  return result;
}

}  // namespace

BoardCorners find_board(const cv::Mat& image, const Board& board) {
  BoardCorners rough;
  for (const cv::Point2f& corner : find_roughly(image, {board.columns, board.rows}))
    rough.emplace_back(corner.x, corner.y);
  if (rough.empty()) return {};
  rough = in_order(rough, board, image);
  BoardCorners result = refined(image, rough, board);
  const auto seen = std::count_if(result.begin(), result.end(),
                                  [](const Vector2d& corner) { return corner.allFinite(); });
  if (2 * seen < static_cast<long>(result.size())) return {};
  return result;
}

std::pair<int, int> size_of_any_board(const cv::Mat& image) {
  const cv::Size least(3, 3);
  const double scale = std::min(1.0, kReducedSide / std::max(image.cols, image.rows));
  for (const double bright_share : kBrightShares) {
    cv::Mat seen = stretched(image, kDarkShare, bright_share);
    cv::resize(seen, seen, cv::Size(), scale, scale, cv::INTER_AREA);
    std::vector<cv::Point2f> corners;
    cv::Mat grid;
    if (cv::findChessboardCornersSB(seen, least, corners, cv::CALIB_CB_LARGER, grid))
      return {std::max(grid.cols, grid.rows), std::min(grid.cols, grid.rows)};
  }
  return {0, 0};
}

}  // namespace scan_calibration
