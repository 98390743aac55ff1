// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace scan_calibration {

/// A drawing as SVG, in the units of its data, with a frame and numbers at its sides. Colours are
/// CSS colours.
class Chart {
 public:
  struct Side {
    std::string label;
    double from;
    double to;  //!< may be less than `from`: the side then counts down
  };
  using Places = std::vector<Eigen::Vector2d>;

  /// @param width, height [px] of the picture
  Chart(int width, int height, const Side& across, const Side& upwards);

  /// @param radius [px]
  void dots(const Places& places, const std::string& colour, double radius);

  /// Draws a line from the first place to the second, from the third to the fourth, and so on.
  /// @param width [px]
  void lines(const Places& ends, const std::string& colour, double width = 1);

  void outline(const Places& corners, const std::string& colour);
  void fill(const Places& corners, const std::string& colour);

  /// [px] per unit across
  double scale() const { return width_ / std::abs(across_.to - across_.from); }

  std::string svg() const;

 private:
  std::string at(const Eigen::Vector2d& place) const;
  std::string path(const Places& corners) const;

  double width_, height_;  // [px] inside the frame
  Side across_, upwards_;
  std::string shapes_;
};

/// Colours to tell `count` things apart.
std::string colour_of(std::size_t index, std::size_t count);

/// Blue at -1, grey at 0, red at 1 and beyond, in eleven steps.
std::string colour_between(double value);

}  // namespace scan_calibration
