// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "quality/figures.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "images/parallel.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;

using scan_cell_common::kMillimetres;

/// Gauss-Newton on the six numbers of the pose, starting at the robot's pose.
/// @return false if a corner is not in front of the camera
bool fit_pose(const ScannerState& state, const BoardSurface& surface, const BoardView& view,
              Isometry3d& pose) {
  constexpr int kMaxSteps = 30;         // chosen: five are usual
  constexpr double kConverged = 1e-12;  // [rad] and [m] chosen: rounding
  Projection projection;
  for (int step = 0; step < kMaxSteps; ++step) {
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
    if (motion.norm() < kConverged) break;
  }
  return true;
}

SquareSum plane_squares(const ScannerState& state, const BoardSurface& surface,
                        const BoardSight& sight, const LinePoints& line,
                        const Eigen::Vector3d& plane) {
  SquareSum result;
  LineOffset offset;
  for (std::size_t i = 0; i < line.pixels.size(); ++i) {
    if (!(line.weights[i] > 0) ||
        !line_offset(state, surface, sight, line.pixels[i], plane, offset)) {
      continue;
    }
    const double distance = offset.value / plane.norm();
    result.add(distance * distance);
  }
  return result;
}

std::vector<double> plane_rms(const std::vector<SquareSum>& planes) {
  std::vector<double> result;
  for (const SquareSum& plane : planes)
    result.push_back(kMillimetres * plane.rms());
  return result;
}

JudgedView judge_view(const ScannerState& state, const BoardSurface& surface,
                      const BoardView& view) {
  JudgedView judged;
  judged.camera_to_board = (view.measured * state.flange_to_camera).inverse() * state.base_to_board;
  if (!fit_pose(state, surface, view, judged.camera_to_board)) {
    throw scan_cell_common::UnusableInput("view " + view.name, "no pose fits its corners",
                                          "check its corners");
  }
  const BoardSight sight = board_sight(judged.camera_to_board);
  judged.corner_residuals = corner_residuals(state, surface, sight, view);
  for (std::size_t i = 0; i < view.pixels.size(); ++i)
    if (view.weights[i] > 0) judged.corners.add(judged.corner_residuals[i].squaredNorm());
  for (std::size_t laser = 0; laser < view.lines.size(); ++laser)
    judged.planes.push_back(
        plane_squares(state, surface, sight, view.lines[laser], state.planes[laser]));
  judged.centre = view.measured * state.flange_to_camera * judged.camera_to_board *
                  on_board(surface, state.bend, surface.centre());
  return judged;
}

Eigen::Vector3d board_centre(const ScannerState& state, const BoardSurface& surface) {
  return state.base_to_board * on_board(surface, state.bend, surface.centre());
}

/// Sums over judged views.
struct FigureSums {
  explicit FigureSums(std::size_t lasers) : planes(lasers) {}

  /// @param offset [m] of the board's centre from its expected place
  void add(const JudgedView& view, const Eigen::Vector3d& offset) {
    corners.add(view.corners);
    offsets.add(offset.squaredNorm());
    for (std::size_t laser = 0; laser < planes.size(); ++laser)
      planes[laser].add(view.planes[laser]);
  }
  void add(const FigureSums& others) {
    corners.add(others.corners);
    offsets.add(others.offsets);
    for (std::size_t laser = 0; laser < planes.size(); ++laser)
      planes[laser].add(others.planes[laser]);
  }
  Figures figures() const {
    return {corners.rms(), plane_rms(planes), kMillimetres * offsets.rms()};
  }

  SquareSum corners, offsets;
  std::vector<SquareSum> planes;
};

}  // namespace

std::vector<JudgedView> judge(const ScannerState& state, const BoardSurface& surface,
                              const BoardViews& views) {
  std::vector<JudgedView> result;
  for (const BoardView& view : views)
    result.push_back(judge_view(state, surface, view));
  return result;
}

ViewFigures JudgedView::figures(const BoardView& view, const ScannerState& state,
                                const BoardSurface& surface) const {
  ViewFigures result;
  result.name = view.name;
  result.reprojection_rms_px = corners.rms();
  result.laser_plane_rms_mm = plane_rms(planes);
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

Figures fitted_figures(const std::vector<JudgedView>& views, std::size_t lasers) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const JudgedView& view : views)
    mean += view.centre / static_cast<double>(views.size());
  FigureSums sums(lasers);
  for (const JudgedView& view : views)
    sums.add(view, view.centre - mean);
  return sums.figures();
}

Figures held_out_figures(const BoardViews& views, const BoardSurface& surface, std::size_t lasers,
                         int folds, int threads,
                         const std::function<ScannerState(const std::vector<bool>&)>& fitted) {
  const auto count =
      static_cast<std::size_t>(std::clamp(folds, 2, std::max(2, static_cast<int>(views.size()))));
  std::vector<FigureSums> by_fold(count, FigureSums(lasers));
  for_each_index(static_cast<int>(count), threads, [&](int fold) {
    std::vector<bool> keep;
    for (std::size_t i = 0; i < views.size(); ++i)
      keep.push_back(i % count != static_cast<std::size_t>(fold));
    const ScannerState model = fitted(keep);
    for (std::size_t i = 0; i < views.size(); ++i) {
      if (keep[i]) continue;
      const JudgedView judged = judge_view(model, surface, views[i]);
      by_fold[fold].add(judged, judged.centre - board_centre(model, surface));
    }
  });
  FigureSums sums(lasers);
  for (const FigureSums& one : by_fold)
    sums.add(one);
  return sums.figures();
}

}  // namespace scan_calibration
