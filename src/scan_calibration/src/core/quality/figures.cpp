// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "quality/figures.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "checks/hand_eye.h"
#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;

constexpr double kMillimetres = 1e3;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Gauss-Newton on the six numbers of the pose, from where the robot says.
/// @return false if a corner is not in front of the camera
bool fit_pose(const ScannerState& state, const BoardSurface& surface, const BoardView& view,
              Isometry3d& pose) {
  constexpr int kMostSteps = 30;
  constexpr double kStill = 1e-12;
  Projection projection;
  for (int step = 0; step < kMostSteps; ++step) {
    Matrix6d normal = Matrix6d::Zero();
    Vector6d right = Vector6d::Zero();
    for (std::size_t i = 0; i < view.pixels.size(); ++i) {
      const Eigen::Vector3d lever = pose.linear() * on_board(surface, state.bend, view.places[i]);
      if (!project(state.camera, lever + pose.translation(), projection)) return false;
      Eigen::Matrix<double, 2, 6> rows;
      for (int k = 0; k < 2; ++k)
        rows.row(k).head<3>() = lever.cross(projection.by_point.row(k).transpose());
      rows.rightCols<3>() = projection.by_point;
      normal += view.weights[i] * rows.transpose() * rows;
      right += view.weights[i] * rows.transpose() * (view.pixels[i] - projection.pixel);
    }
    const Vector6d motion = normal.ldlt().solve(right);
    if (!motion.allFinite()) return false;
    const Eigen::Vector3d turn = motion.head<3>();
    if (turn.norm() > 0)
      pose.linear() =
          nearest_rotation(Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.linear());
    pose.translation() += motion.tail<3>();
    if (motion.norm() < kStill) break;
  }
  return true;
}

void judge_lines(const ScannerState& state, const BoardSurface& surface, const BoardView& view,
                 JudgedView& judged) {
  const BoardSight sight = board_sight(judged.camera_to_board);
  LineOffset offset;
  for (std::size_t laser = 0; laser < view.lines.size(); ++laser) {
    const LinePoints& line = view.lines[laser];
    std::vector<double> distances(line.pixels.size(), kNone);
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < line.pixels.size(); ++i) {
      if (!(line.weights[i] > 0) ||
          !line_offset(state, surface, sight, line.pixels[i], state.planes[laser], offset)) {
        continue;
      }
      distances[i] = offset.value / state.planes[laser].norm();
      squares += distances[i] * distances[i];
      count += 1;
    }
    judged.plane_distances.push_back(distances);
    judged.plane_squares.push_back(squares);
    judged.plane_counts.push_back(count);
  }
}

}  // namespace

JudgedView judge(const ScannerState& state, const BoardSurface& surface, const BoardView& view) {
  JudgedView judged;
  judged.camera_to_board = (view.measured * state.flange_to_camera).inverse() * state.base_to_board;
  if (!fit_pose(state, surface, view, judged.camera_to_board)) {
    throw scan_cell_common::UnusableInput("view " + view.name, "its corners fit no pose",
                                          "check its corners");
  }
  judged.corner_residuals =
      corner_residuals(state, surface, board_sight(judged.camera_to_board), view);
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    if (!(view.weights[i] > 0)) continue;
    judged.corner_squares += judged.corner_residuals[i].squaredNorm();
    judged.corner_count += 1;
  }
  judge_lines(state, surface, view, judged);
  judged.centre = view.measured * state.flange_to_camera * judged.camera_to_board *
                  on_board(surface, state.bend, surface.centre());
  return judged;
}

ViewFigures JudgedView::figures(const BoardView& view, const ScannerState& state,
                                const BoardSurface& surface) const {
  ViewFigures result;
  result.name = view.name;
  result.reprojection_rms_px = std::sqrt(corner_squares / corner_count);
  for (std::size_t laser = 0; laser < plane_squares.size(); ++laser)
    result.laser_plane_rms_mm.push_back(kMillimetres *
                                        std::sqrt(plane_squares[laser] / plane_counts[laser]));
  result.board_offset_mm = kMillimetres * (centre - board_centre(state, surface)).norm();
  const Isometry3d seen = view.measured * state.flange_to_camera * camera_to_board;
  result.board_angle_deg =
      angle_of(state.base_to_board.linear().transpose() * seen.linear()) * 180 / M_PI;
  result.corner_residuals = corner_residuals;
  for (std::size_t i = 0; i < view.weights.size(); ++i)
    if (!(view.weights[i] > 0)) result.left_out_corners.push_back(i);
  for (const LinePoints& line : view.lines) {
    result.left_out_points.emplace_back();
    for (std::size_t i = 0; i < line.weights.size(); ++i)
      if (!(line.weights[i] > 0)) result.left_out_points.back().push_back(line.index[i]);
  }
  return result;
}

void FigureSums::add(const JudgedView& view, const Eigen::Vector3d& offset) {
  corner_squares_ += view.corner_squares;
  corner_count_ += view.corner_count;
  offset_squares_ += offset.squaredNorm();
  views_ += 1;
  for (std::size_t laser = 0; laser < plane_squares_.size(); ++laser) {
    plane_squares_[laser] += view.plane_squares[laser];
    plane_counts_[laser] += view.plane_counts[laser];
  }
}

void FigureSums::add(const FigureSums& others) {
  corner_squares_ += others.corner_squares_;
  corner_count_ += others.corner_count_;
  offset_squares_ += others.offset_squares_;
  views_ += others.views_;
  for (std::size_t laser = 0; laser < plane_squares_.size(); ++laser) {
    plane_squares_[laser] += others.plane_squares_[laser];
    plane_counts_[laser] += others.plane_counts_[laser];
  }
}

Figures FigureSums::figures() const {
  Figures result;
  result.reprojection_rms_px = std::sqrt(corner_squares_ / corner_count_);
  for (std::size_t laser = 0; laser < plane_squares_.size(); ++laser)
    result.laser_plane_rms_mm.push_back(kMillimetres *
                                        std::sqrt(plane_squares_[laser] / plane_counts_[laser]));
  result.board_scatter_mm = kMillimetres * std::sqrt(offset_squares_ / views_);
  return result;
}

Figures fitted_figures(const std::vector<JudgedView>& views, std::size_t lasers) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const JudgedView& view : views)
    mean += view.centre / static_cast<double>(views.size());
  FigureSums sums(lasers);
  for (const JudgedView& view : views)
    sums.add(view, view.centre - mean);
  return sums.figures();
}

Eigen::Vector3d board_centre(const ScannerState& state, const BoardSurface& surface) {
  return state.base_to_board * on_board(surface, state.bend, surface.centre());
}

std::vector<std::size_t> fold_of_each(std::size_t count, int folds) {
  const std::size_t groups =
      std::clamp(static_cast<std::size_t>(std::max(folds, 2)), std::size_t{2}, count);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(i % groups);
  return result;
}

}  // namespace scan_calibration
