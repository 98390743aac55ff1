// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "images/rough_camera.h"

#include <fmt/core.h>

#include <algorithm>
#include <opencv2/calib3d.hpp>

#include "geometry/opencv.h"
#include "geometry/statistics.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

using scan_cell_common::CameraIntrinsics;
using scan_cell_common::UnusableInput;

/// At most `most` of the corners, spread evenly.
BoardPoints points_of(const BoardCorners& corners, const Board& board, std::size_t most) {
  BoardPoints points;
  const std::size_t stride = std::max<std::size_t>(1, corners.size() / most) | 1U;
  for (std::size_t i = 0; i < corners.size(); i += stride) {
    const auto column = static_cast<double>(i % board.columns);
    const auto row = static_cast<double>(i / board.columns);
    if (corners[i].allFinite())
      points.add(Eigen::Vector2d(column, row) * board.square_size, corners[i]);
  }
  return points;
}

CameraIntrinsics solve(const std::vector<BoardPoints>& views, int width, int height,
                       std::vector<double>& errors) {
  const BoardPointLists points(views);
  cv::Mat matrix, distortion, rotations, translations, deviations, pose_deviations, view_errors;
  try {
    cv::calibrateCamera(points.places, points.pixels, {width, height}, matrix, distortion,
                        rotations, translations, deviations, pose_deviations, view_errors,
                        cv::CALIB_FIX_K3);
  } catch (const cv::Exception& error) {
    throw UnusableInput("views of the board", "do not determine a camera: " + error.err,
                        "tilt the board to the camera, in several directions");
  }
  errors.assign(view_errors.begin<double>(), view_errors.end<double>());
  return intrinsics(width, height, matrix, distortion);
}

}  // namespace

CameraIntrinsics rough_camera(const std::vector<BoardCorners>& views, const Board& board, int width,
                              int height) {
  constexpr std::size_t kMaxViews = 20;    // chosen: more take longer and tell little
  constexpr std::size_t kMaxCorners = 60;  // a view, chosen
  constexpr std::size_t kMinViews = 3;     // Zhang 2000
  constexpr double kMaxError = 4;          // over the median of the views, chosen
  std::vector<const BoardCorners*> seen;
  for (const BoardCorners& corners : views)
    if (!corners.empty()) seen.push_back(&corners);
  if (seen.size() < kMinViews) {
    throw UnusableInput("views that show the board", std::to_string(seen.size()),
                        fmt::format("give at least {}, each tilted differently", kMinViews));
  }
  std::vector<BoardPoints> chosen;
  const std::size_t count = std::min(kMaxViews, seen.size());
  for (std::size_t i = 0; i < count; ++i)
    chosen.push_back(points_of(*seen[i * seen.size() / count], board, kMaxCorners));
  std::vector<double> errors;
  CameraIntrinsics camera = solve(chosen, width, height, errors);
  const double max_error = kMaxError * upper_median(errors);
  std::vector<BoardPoints> good;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (errors[i] <= max_error) good.push_back(chosen[i]);
  if (good.size() < chosen.size() && good.size() >= kMinViews)
    camera = solve(good, width, height, errors);
  return camera;
}

Eigen::Isometry3d rough_board_pose(const CameraIntrinsics& camera, const BoardCorners& corners,
                                   const Board& board) {
  const BoardPoints points = points_of(corners, board, corners.size());
  cv::Vec3d rotation, translation;
  cv::solvePnP(points.places, points.pixels, camera_matrix(camera), distortion(camera), rotation,
               translation);
  return pose_of(rotation, translation);
}

}  // namespace scan_calibration
