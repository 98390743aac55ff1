// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <string>

namespace tool_path_stretcher {

/// Where points are looked at from. Points come to lie on the picture's axes: right, up, and
/// towards the eye.
struct View {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  //!< rows: right, up, towards the eye

  /// From the side `azimuth` about z and `elevation` above the x-y plane [rad].
  static View from(double azimuth, double elevation);
};

/// A picture in parallel projection, whose nearer dots hide the farther ones.
class Canvas {
 public:
  Canvas(int width, int height);

  /// What is drawn fits between the margins [pixels]; of `low` and `high` as seen.
  void fit(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int top_margin, int margin);

  double pixels_per_metre() const { return scale_; }

  /// A round dot at a place as seen; `lift` [m] brings it nearer to the eye.
  void dot(const Eigen::Vector3d& at, double radius, const cv::Vec3b& colour, double lift = 0);

  /// A line over all else, as thin as can be.
  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const cv::Vec3b& colour);

  /// At a place of the picture [pixels] from its upper left corner.
  void text(const std::string& words, int x, int y, double height, const cv::Vec3b& colour);
  void bar(int x, int y, int width, int height, const cv::Vec3b& colour);

  int width() const;
  int height() const;

  /// @throw scan_cell_common::FileError if it cannot be written
  void save(const std::string& path) const;

 private:
  static constexpr int kFiner = 2;  // drawn larger, then reduced: smooth edges

  Eigen::Vector2d place_of(const Eigen::Vector3d& at) const;

  cv::Mat image_;
  cv::Mat depth_;
  double scale_ = 1;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
};

/// Blue, green, red, as OpenCV keeps them, of a colour for a value of 0 .. 1: from dark blue to
/// yellow.
cv::Vec3b heat(double value);

}  // namespace tool_path_stretcher
