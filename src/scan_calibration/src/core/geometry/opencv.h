// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_calibration {

inline cv::Matx33d camera_matrix(const scan_cell_common::CameraIntrinsics& camera) {
  return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

inline cv::Vec<double, 5> distortion(const scan_cell_common::CameraIntrinsics& camera) {
  return cv::Vec<double, 5>(camera.distortion.data());
}

/// @param matrix, distortion as cv::calibrateCamera() returns them
inline scan_cell_common::CameraIntrinsics intrinsics(int width, int height, const cv::Mat& matrix,
                                                     const cv::Mat& distortion) {
  scan_cell_common::CameraIntrinsics camera{width,
                                            height,
                                            matrix.at<double>(0, 0),
                                            matrix.at<double>(1, 1),
                                            matrix.at<double>(0, 2),
                                            matrix.at<double>(1, 2)};
  for (int i = 0; i < 5; ++i)
    camera.distortion[i] = distortion.at<double>(i);
  return camera;
}

/// Corners of a board as OpenCV takes them.
struct BoardPoints {
  std::vector<cv::Point3f> places;  // [m]
  std::vector<cv::Point2f> pixels;

  void add(const Eigen::Vector2d& place, const Eigen::Vector2d& pixel) {
    places.emplace_back(static_cast<float>(place.x()), static_cast<float>(place.y()), 0.F);
    pixels.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  }
};

/// Corners of several views, as cv::calibrateCamera() takes them.
struct BoardPointLists {
  explicit BoardPointLists(const std::vector<BoardPoints>& views) {
    for (const BoardPoints& view : views) {
      places.push_back(view.places);
      pixels.push_back(view.pixels);
    }
  }
  std::vector<std::vector<cv::Point3f>> places;
  std::vector<std::vector<cv::Point2f>> pixels;
};

/// @param rotation rotation vector [rad]
/// @param translation [m]
inline Eigen::Isometry3d pose_of(const cv::Vec3d& rotation, const cv::Vec3d& translation) {
  const Eigen::Vector3d axis(rotation[0], rotation[1], rotation[2]);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (axis.norm() > 0)
    pose.linear() = Eigen::AngleAxisd(axis.norm(), axis.normalized()).toRotationMatrix();
  pose.translation() << translation[0], translation[1], translation[2];
  return pose;
}

}  // namespace scan_calibration
