// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <string>

namespace tool_path_stretcher {

/// The direction from which points are viewed. Maps points to the picture's axes: right, up, and
/// towards the eye.
struct View {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  //!< rows: right, up, towards the eye

  /// A view from `azimuth` about z and `elevation` above the x-y plane [rad].
  static View from(double azimuth, double elevation);
};

/// A picture in parallel projection; nearer dots hide farther ones.
class Canvas {
 public:
  Canvas(int width, int height);

  /// Fits the drawing, which spans `low` to `high` as seen, between the margins [pixels].
  void fit(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int top_margin, int margin);

  double pixels_per_metre() const { return scale_; }

  /// A round dot at a place as seen; `lift` [m] brings it nearer to the eye.
  void dot(const Eigen::Vector3d& at, double radius, const cv::Vec3b& colour, double lift = 0);

  /// The thinnest line, drawn over everything else.
  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const cv::Vec3b& colour);

  /// Writes text at a position [pixels] from the picture's upper left corner.
  void text(const std::string& words, int x, int y, double height, const cv::Vec3b& colour);
  void bar(int x, int y, int width, int height, const cv::Vec3b& colour);

  int width() const;
  int height() const;

  /// @throw scan_cell_common::FileError if it cannot be written
  void save(const std::string& path) const;

 private:
  static constexpr int kFiner = 2;  // drawn larger, then reduced, for smooth edges

  Eigen::Vector2d place_of(const Eigen::Vector3d& at) const;

  cv::Mat image_;
  cv::Mat depth_;
  double scale_ = 1;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
};

/// Colour for a value of 0 .. 1, from dark blue to yellow, in OpenCV's order blue, green, red.
cv::Vec3b heat(double value);

}  // namespace tool_path_stretcher
