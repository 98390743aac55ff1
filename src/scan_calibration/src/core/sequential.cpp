// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "sequential.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "estimate/laser_start.h"
#include "geometry/opencv.h"
#include "quality/figures.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;
using scan_cell_common::CameraIntrinsics;

/// Points of a view, without outliers.
BoardPoints points_of(const BoardView& view) {
  BoardPoints points;
  for (std::size_t i = 0; i < view.places.size(); ++i)
    if (view.weights[i] > 0) points.add(view.places[i], view.pixels[i]);
  return points;
}

/// Intrinsics, and the board's pose in each view.
std::vector<Isometry3d> calibrate_camera(const BoardViews& views, ScannerState& state) {
  std::vector<BoardPoints> seen;
  std::transform(views.begin(), views.end(), std::back_inserter(seen), points_of);
  const BoardPointLists points(seen);
  cv::Mat matrix, distortion;
  std::vector<cv::Vec3d> rotations, translations;
  cv::calibrateCamera(points.places, points.pixels, {state.width, state.height}, matrix, distortion,
                      rotations, translations);
  state.camera = camera_vector(intrinsics(state.width, state.height, matrix, distortion));
  std::vector<Isometry3d> boards;
  std::transform(rotations.begin(), rotations.end(), translations.begin(),
                 std::back_inserter(boards), pose_of);
  return boards;
}

/// The board's pose in each view of a known camera.
std::vector<Isometry3d> boards_in(const CameraIntrinsics& camera, const BoardViews& views) {
  std::vector<Isometry3d> boards;
  for (const BoardView& view : views) {
    const BoardPoints points = points_of(view);
    cv::Vec3d rotation, translation;
    cv::solvePnP(points.places, points.pixels, camera_matrix(camera), distortion(camera), rotation,
                 translation);
    boards.push_back(pose_of(rotation, translation));
  }
  return boards;
}

Isometry3d hand_eye(const BoardViews& views, const std::vector<Isometry3d>& boards) {
  struct Motions {
    void add(const Isometry3d& pose) {
      cv::eigen2cv(Eigen::Matrix3d(pose.linear()), rotations.emplace_back());
      cv::eigen2cv(Eigen::Vector3d(pose.translation()), translations.emplace_back());
    }
    std::vector<cv::Mat> rotations, translations;
  } flange, board;
  for (std::size_t i = 0; i < views.size(); ++i) {
    flange.add(views[i].measured);
    board.add(boards[i]);
  }
  cv::Mat rotation, translation;
  cv::calibrateHandEye(flange.rotations, flange.translations, board.rotations, board.translations,
                       rotation, translation, cv::CALIB_HAND_EYE_PARK);
  Eigen::Matrix3d linear;
  cv::cv2eigen(rotation, linear);
  Isometry3d camera = Isometry3d::Identity();
  camera.linear() = linear;
  camera.translation() << translation.at<double>(0), translation.at<double>(1),
      translation.at<double>(2);
  return camera;
}

/// Mean of the board's pose in base_link over the views.
Isometry3d mean_board(const BoardViews& views, const std::vector<Isometry3d>& boards,
                      const Isometry3d& camera) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Isometry3d board = views[i].measured * camera * boards[i];
    turn += board.linear();
    shift += board.translation() / static_cast<double>(views.size());
  }
  Isometry3d result = Isometry3d::Identity();
  result.linear() = nearest_rotation(turn);
  result.translation() = shift;
  return result;
}

/// @param known supplies camera and flange_to_camera
ScannerState calibrate_in_sequence(const BoardViews& views, const BoardSurface& surface,
                                   const Observations& observations,
                                   const std::optional<scan_cell_common::ScannerModel>& known) {
  ScannerState state;
  state.width = observations.width;
  state.height = observations.height;
  if (known) state.camera = camera_vector(known->camera);
  const std::vector<Isometry3d> boards =
      known ? boards_in(known->camera, views) : calibrate_camera(views, state);
  state.flange_to_camera = known ? known->flange_to_camera : hand_eye(views, boards);
  state.base_to_board = mean_board(views, boards, state.flange_to_camera);
  for (std::size_t laser = 0; laser < observations.lasers.size(); ++laser) {
    const PlaneFit plane = plane_through(
        laser_points(state, surface, views, boards, laser, observations.lasers[laser]));
    state.planes.emplace_back(plane.normal / plane.distance);
  }
  return state;
}

}  // namespace

SequentialCalibration calibrate_sequentially(
    const Observations& observations, int folds,
    const std::optional<scan_cell_common::ScannerModel>& known) {
  const BoardSurface surface(observations.board);
  const std::size_t lasers = observations.lasers.size();
  BoardViews views;
  for (std::size_t i = 0; i < observations.views.size(); ++i)
    views.push_back(board_view(observations, i));
  if (views.size() < 3) {
    throw scan_cell_common::UnusableInput("views of the session", fmt::format("{}", views.size()),
                                          "give at least three");
  }
  const ScannerState state = calibrate_in_sequence(views, surface, observations, known);
  SequentialCalibration result;
  result.scanner = scanner_model(state, observations.lasers, {});
  result.base_to_board = state.base_to_board;
  result.fitted = fitted_figures(judge(state, surface, views), lasers);
  result.held_out =
      held_out_figures(views, surface, lasers, folds, 1, [&](const std::vector<bool>& keep) {
        BoardViews kept;
        for (std::size_t i = 0; i < views.size(); ++i)
          if (keep[i]) kept.push_back(views[i]);
        return calibrate_in_sequence(kept, surface, observations, known);
      });
  return result;
}

Observations used_views(const Observations& observations, const Calibration& calibration) {
  Observations used = observations;
  used.views.clear();
  for (const ViewFigures& figures : calibration.views) {
    const auto found =
        std::find_if(observations.views.begin(), observations.views.end(),
                     [&](const ViewObservation& view) { return view.name == figures.name; });
    if (found == observations.views.end()) continue;
    ViewObservation view = *found;
    for (auto i = figures.left_out_corners.rbegin(); i != figures.left_out_corners.rend(); ++i)
      view.corners.erase(view.corners.begin() + static_cast<std::ptrdiff_t>(*i));
    for (std::size_t laser = 0; laser < view.lines.size(); ++laser) {
      const bool rejected = std::any_of(
          calibration.rejected.begin(), calibration.rejected.end(), [&](const RejectedView& one) {
            return one.name == view.name && one.laser == observations.lasers[laser];
          });
      if (rejected) view.lines[laser].clear();
    }
    used.views.push_back(std::move(view));
  }
  return used;
}

}  // namespace scan_calibration
