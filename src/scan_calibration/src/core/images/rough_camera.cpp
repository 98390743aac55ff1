// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "images/rough_camera.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

using scan_cell_common::CameraIntrinsics;
using scan_cell_common::UnusableInput;

struct Correspondences {
  std::vector<cv::Point3f> on_board;  // [m]
  std::vector<cv::Point2f> in_image;  // [px]
};

/// At most `most` of the corners, spread evenly.
Correspondences correspondences(const BoardCorners& corners, const Board& board, std::size_t most) {
  Correspondences result;
  const std::size_t stride = std::max<std::size_t>(1, corners.size() / most) | 1U;
  for (std::size_t i = 0; i < corners.size(); i += stride) {
    if (!corners[i].allFinite()) continue;
    const auto column = static_cast<double>(i % board.columns);
    const auto row = static_cast<double>(i / board.columns);
    result.on_board.emplace_back(column * board.square_size, row * board.square_size, 0);
    result.in_image.emplace_back(corners[i].x(), corners[i].y());
  }
  return result;
}

cv::Matx33d matrix_of(const CameraIntrinsics& camera) {
  return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

cv::Mat distortion_of(const CameraIntrinsics& camera) {
  return cv::Mat(1, 5, CV_64F, const_cast<double*>(camera.distortion.data())).clone();
}

CameraIntrinsics solve(const std::vector<Correspondences>& views, int width, int height,
                       std::vector<double>& errors) {
  std::vector<std::vector<cv::Point3f>> on_board;
  std::vector<std::vector<cv::Point2f>> in_image;
  for (const Correspondences& view : views) {
    on_board.push_back(view.on_board);
    in_image.push_back(view.in_image);
  }
  cv::Mat matrix, distortion, rotations, translations, deviations, pose_deviations, view_errors;
  try {
    cv::calibrateCamera(on_board, in_image, {width, height}, matrix, distortion, rotations,
                        translations, deviations, pose_deviations, view_errors, cv::CALIB_FIX_K3);
  } catch (const cv::Exception& error) {
    throw UnusableInput("views of the board", "give no camera: " + error.err,
                        "tilt the board to the camera, in several directions");
  }
  errors.assign(view_errors.begin<double>(), view_errors.end<double>());
  CameraIntrinsics camera{width,
                          height,
                          matrix.at<double>(0, 0),
                          matrix.at<double>(1, 1),
                          matrix.at<double>(0, 2),
                          matrix.at<double>(1, 2)};
  for (int i = 0; i < 5; ++i)
    camera.distortion[i] = distortion.at<double>(i);
  return camera;
}

}  // namespace

CameraIntrinsics rough_camera(const std::vector<BoardCorners>& views, const Board& board, int width,
                              int height) {
  constexpr std::size_t kMostViews = 20, kMostCorners = 60, kLeastViews = 3;
  constexpr double kMostError = 4;  // times the median of the views
  std::vector<const BoardCorners*> seen;
  for (const BoardCorners& corners : views)
    if (!corners.empty()) seen.push_back(&corners);
  if (seen.size() < kLeastViews) {
    throw UnusableInput("views that show the board", std::to_string(seen.size()),
                        "give at least " + std::to_string(kLeastViews) + ", tilted differently");
  }
  std::vector<Correspondences> chosen;
  const std::size_t count = std::min(kMostViews, seen.size());
  for (std::size_t i = 0; i < count; ++i)
    chosen.push_back(correspondences(*seen[i * seen.size() / count], board, kMostCorners));
  std::vector<double> errors;
  CameraIntrinsics camera = solve(chosen, width, height, errors);
  std::vector<double> sorted = errors;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Correspondences> good;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (errors[i] <= kMostError * sorted[sorted.size() / 2]) good.push_back(chosen[i]);
  if (good.size() < chosen.size() && good.size() >= kLeastViews)
    camera = solve(good, width, height, errors);
  return camera;
}

Eigen::Isometry3d rough_board_pose(const CameraIntrinsics& camera, const BoardCorners& corners,
                                   const Board& board) {
  const Correspondences seen = correspondences(corners, board, corners.size());
  cv::Vec3d rotation, translation;
  cv::solvePnP(seen.on_board, seen.in_image, matrix_of(camera), distortion_of(camera), rotation,
               translation);
  const Eigen::Vector3d axis(rotation[0], rotation[1], rotation[2]);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (axis.norm() > 0)
    pose.linear() = Eigen::AngleAxisd(axis.norm(), axis.normalized()).toRotationMatrix();
  pose.translation() << translation[0], translation[1], translation[2];
  return pose;
}

}  // namespace scan_calibration
