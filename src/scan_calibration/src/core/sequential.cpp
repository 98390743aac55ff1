// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_calibration/sequential.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "checks/hand_eye.h"
#include "estimate/laser_start.h"
#include "quality/figures.h"
#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;

Isometry3d pose_of(const cv::Mat& turn, const cv::Mat& shift) {
  cv::Mat matrix;
  cv::Rodrigues(turn, matrix);
  Isometry3d pose = Isometry3d::Identity();
  Eigen::Matrix3d rotation;
  cv::cv2eigen(matrix, rotation);
  pose.linear() = rotation;
  pose.translation() << shift.at<double>(0), shift.at<double>(1), shift.at<double>(2);
  return pose;
}

struct SeenBoard {
  std::vector<cv::Point3f> places;  // [m]
  std::vector<cv::Point2f> pixels;
};

/// Without the corners that are left out.
SeenBoard seen_board(const BoardView& view) {
  SeenBoard seen;
  for (std::size_t i = 0; i < view.places.size(); ++i) {
    if (!(view.weights[i] > 0)) continue;
    seen.places.emplace_back(static_cast<float>(view.places[i].x()),
                             static_cast<float>(view.places[i].y()), 0.f);
    seen.pixels.emplace_back(static_cast<float>(view.pixels[i].x()),
                             static_cast<float>(view.pixels[i].y()));
  }
  return seen;
}

/// Intrinsics; a board pose a view.
std::vector<Isometry3d> calibrate_camera(const BoardViews& views, ScannerState& state) {
  std::vector<std::vector<cv::Point3f>> places;
  std::vector<std::vector<cv::Point2f>> pixels;
  for (const BoardView& view : views) {
    const SeenBoard seen = seen_board(view);
    places.push_back(seen.places);
    pixels.push_back(seen.pixels);
  }
  cv::Mat matrix, distortion;
  std::vector<cv::Mat> turns, shifts;
  cv::calibrateCamera(places, pixels, cv::Size(state.width, state.height), matrix, distortion,
                      turns, shifts);
  state.camera << matrix.at<double>(0, 0), matrix.at<double>(1, 1), matrix.at<double>(0, 2),
      matrix.at<double>(1, 2), distortion.at<double>(0), distortion.at<double>(1),
      distortion.at<double>(2), distortion.at<double>(3), distortion.at<double>(4);
  std::vector<Isometry3d> boards;
  for (std::size_t i = 0; i < turns.size(); ++i)
    boards.push_back(pose_of(turns[i], shifts[i]));
  return boards;
}

/// A board pose a view in a camera that is known.
std::vector<Isometry3d> boards_in(const scan_cell_common::CameraIntrinsics& camera,
                                  const BoardViews& views) {
  const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const std::vector<double> distortion(camera.distortion.begin(), camera.distortion.end());
  std::vector<Isometry3d> boards;
  for (const BoardView& view : views) {
    const SeenBoard seen = seen_board(view);
    cv::Mat turn, shift;
    cv::solvePnP(seen.places, seen.pixels, matrix, distortion, turn, shift);
    boards.push_back(pose_of(turn, shift));
  }
  return boards;
}

Isometry3d hand_eye(const BoardViews& views, const std::vector<Isometry3d>& boards) {
  std::vector<cv::Mat> flange_turns, flange_shifts, board_turns, board_shifts;
  const auto add = [](const Isometry3d& pose, std::vector<cv::Mat>& turns,
                      std::vector<cv::Mat>& shifts) {
    turns.emplace_back();
    shifts.emplace_back();
    cv::eigen2cv(Eigen::Matrix3d(pose.linear()), turns.back());
    cv::eigen2cv(Eigen::Vector3d(pose.translation()), shifts.back());
  };
  for (std::size_t i = 0; i < views.size(); ++i) {
    add(views[i].measured, flange_turns, flange_shifts);
    add(boards[i], board_turns, board_shifts);
  }
  cv::Mat turn, shift;
  cv::calibrateHandEye(flange_turns, flange_shifts, board_turns, board_shifts, turn, shift,
                       cv::CALIB_HAND_EYE_PARK);
  Isometry3d camera = Isometry3d::Identity();
  Eigen::Matrix3d rotation;
  cv::cv2eigen(turn, rotation);
  camera.linear() = rotation;
  camera.translation() << shift.at<double>(0), shift.at<double>(1), shift.at<double>(2);
  return camera;
}

/// Mean of where each view has the board.
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

/// Through all points, by singular value decomposition.
Eigen::Vector3d plane_through(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points)
    mean += point / static_cast<double>(points.size());
  Eigen::MatrixX3d about(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    about.row(static_cast<Eigen::Index>(i)) = (points[i] - mean).transpose();
  const Eigen::Vector3d normal =
      Eigen::JacobiSVD<Eigen::MatrixXd>(about, Eigen::ComputeThinV).matrixV().col(2);
  return normal / normal.dot(mean);
}

/// @param known camera and its pose on the flange
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
  LineOffset offset;
  for (std::size_t laser = 0; laser < observations.lasers.size(); ++laser) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < views.size(); ++i)
      for (const Eigen::Vector2d& pixel : views[i].lines[laser].pixels)
        if (line_offset(state, surface, board_sight(boards[i]), pixel, Eigen::Vector3d::UnitX(),
                        offset))
          points.push_back(offset.point);
    if (points.size() < 3)
      throw scan_cell_common::UnusableInput(observations.lasers[laser],
                                            std::to_string(points.size()) + " points",
                                            "give lines of it in three views or more");
    state.planes.push_back(plane_through(points));
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
    throw scan_cell_common::UnusableInput("views of the session", std::to_string(views.size()),
                                          "three are needed");
  }
  const auto calibrated = [&](const BoardViews& part) {
    return calibrate_in_sequence(part, surface, observations, known);
  };
  const ScannerState state = calibrated(views);
  SequentialCalibration result;
  result.scanner = scanner_model(state, observations.lasers, {});
  result.base_to_board = state.base_to_board;
  std::vector<JudgedView> judged;
  for (const BoardView& view : views)
    judged.push_back(judge(state, surface, view));
  result.fitted = fitted_figures(judged, lasers);

  const std::vector<std::size_t> fold_of = fold_of_each(views.size(), folds);
  const std::size_t count = 1 + *std::max_element(fold_of.begin(), fold_of.end());
  FigureSums sums(lasers);
  for (std::size_t fold = 0; fold < count; ++fold) {
    BoardViews kept;
    for (std::size_t i = 0; i < views.size(); ++i)
      if (fold_of[i] != fold) kept.push_back(views[i]);
    const ScannerState model = calibrated(kept);
    for (std::size_t i = 0; i < views.size(); ++i) {
      if (fold_of[i] != fold) continue;
      const JudgedView one = judge(model, surface, views[i]);
      sums.add(one, one.centre - board_centre(model, surface));
    }
  }
  result.held_out = sums.figures();
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
