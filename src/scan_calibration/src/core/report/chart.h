// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace scan_calibration {

/// A drawing in the units of what it shows, with a frame and numbers at its sides.
class Chart {
 public:
  struct Side {
    std::string label;
    double from;
    double to;  //!< may be less than `from`: the side then counts down
  };

  /// @param width, height [px] of the picture
  Chart(int width, int height, const Side& across, const Side& upwards);

  void dot(const Eigen::Vector2d& place, const cv::Scalar& colour, double radius = 2);
  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const cv::Scalar& colour,
            int thickness = 1);
  void fill(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const cv::Scalar& colour);
  void outline(const std::vector<Eigen::Vector2d>& corners, const cv::Scalar& colour);
  void text(const Eigen::Vector2d& place, const std::string& text);

  /// [px] a unit across
  double scale() const;

  /// The picture's bytes. The frame and its numbers are drawn over the rest.
  std::string png();

 private:
  cv::Point2d at(const Eigen::Vector2d& place) const;
  void draw_frame();

  cv::Mat picture_;
  Side across_;
  Side upwards_;
  cv::Rect2d inside_;
};

/// Colours that tell `count` things apart.
cv::Scalar colour_of(std::size_t index, std::size_t count);

/// Blue at -1, grey at 0, red at 1 and beyond.
cv::Scalar colour_between(double value);

}  // namespace scan_calibration
