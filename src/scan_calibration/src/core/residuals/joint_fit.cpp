// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "residuals/joint_fit.h"

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <cmath>
#include <memory>

#include "geometry/statistics.h"
#include "residuals/residuals.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

/// Motions start at zero and are applied to the poses at the end.
struct Unknowns {
  CameraVector camera;
  Vector6d camera_motion = Vector6d::Zero();
  Vector6d board_motion = Vector6d::Zero();
  Eigen::Vector3d bend;
  std::vector<Eigen::Vector3d> planes;
  std::vector<Vector6d> corrections;
};

class Problem {
 public:
  Problem(const ResidualContext& context, const BoardViews& views, const FitChoice& choice)
      : context_(context), unknowns_{context.reference.camera, Vector6d::Zero(),
                                     Vector6d::Zero(),         context.reference.bend,
                                     context.reference.planes, context.reference.corrections} {
    for (std::size_t i = 0; i < views.size(); ++i)
      add(views[i], i, choice);
    problem_.AddResidualBlock(new LensResiduals(context, choice.square_pixels), nullptr,
                              unknowns_.camera.data());
    if (!choice.bend) problem_.SetParameterBlockConstant(unknowns_.bend.data());
    if (!choice.camera) problem_.SetParameterBlockConstant(unknowns_.camera.data());
    if (!choice.camera || !choice.robot)
      problem_.SetParameterBlockConstant(unknowns_.camera_motion.data());
    if (!choice.robot) problem_.SetParameterBlockConstant(unknowns_.board_motion.data());
  }

  void solve() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.linear_solver_ordering = ordering();
    options.num_threads = 1;              // several threads would sum in varying order
    options.max_num_iterations = 100;     // chosen: ten are usual
    options.function_tolerance = 1e-10;   // relative, chosen: far below the figures' last digit
    options.parameter_tolerance = 1e-12;  // relative, chosen
    options.logging_type = ceres::SILENT;
    double cost = 0;  // evaluated first, as Ceres prints where it cannot start
    ceres::Solver::Summary summary;
    const bool possible =
        problem_.Evaluate(ceres::Problem::EvaluateOptions(), &cost, nullptr, nullptr, nullptr);
    if (possible) ceres::Solve(options, &problem_, &summary);
    if (!possible || !summary.IsSolutionUsable()) {
      throw scan_cell_common::UnusableInput(
          "estimate",
          possible ? summary.message : "the closed-form start puts corners behind the camera",
          "check the views and poses of the session");
    }
  }

  ScannerState state() const {
    ScannerState state = context_.reference;
    state.camera = unknowns_.camera;
    state.bend = unknowns_.bend;
    state.flange_to_camera = moved(state.flange_to_camera, unknowns_.camera_motion);
    state.base_to_board = moved(state.base_to_board, unknowns_.board_motion);
    state.planes = unknowns_.planes;
    state.corrections = unknowns_.corrections;
    return state;
  }

 private:
  void add(const BoardView& view, std::size_t index, const FitChoice& choice) {
    double* const correction = unknowns_.corrections[index].data();
    std::vector<double*> blocks = {unknowns_.camera.data(), unknowns_.camera_motion.data(),
                                   unknowns_.board_motion.data(), unknowns_.bend.data(),
                                   correction};
    problem_.AddResidualBlock(new CornerResiduals(context_, view), nullptr, blocks);
    if (!choice.robot) return;
    problem_.AddResidualBlock(new RobotResiduals(context_, view), nullptr, correction);
    blocks.push_back(nullptr);
    for (std::size_t laser = 0; laser < view.lines.size(); ++laser) {
      if (view.lines[laser].pixels.empty()) continue;
      blocks.back() = unknowns_.planes[laser].data();
      problem_.AddResidualBlock(new LineResiduals(context_, view, index, laser), nullptr, blocks);
    }
  }

  /// The views' corrections are eliminated, in one group; each other block has its own group.
  /// Within a group Ceres sorts by address, which differs between threads and would change the last
  /// bit of the result.
  std::shared_ptr<ceres::ParameterBlockOrdering> ordering() {
    auto result = std::make_shared<ceres::ParameterBlockOrdering>();
    const auto place = [&](double* block, int group) {
      if (problem_.HasParameterBlock(block)) result->AddElementToGroup(block, group);
    };
    for (Vector6d& correction : unknowns_.corrections)
      place(correction.data(), 0);
    int group = 0;
    for (double* block : {unknowns_.camera.data(), unknowns_.camera_motion.data(),
                          unknowns_.board_motion.data(), unknowns_.bend.data()})
      place(block, ++group);
    for (Eigen::Vector3d& plane : unknowns_.planes)
      place(plane.data(), ++group);
    return result;
  }

  const ResidualContext& context_;
  Unknowns unknowns_;
  ceres::Problem problem_;
};

constexpr double kFullWeight = 3;  // standard deviations, chosen: 0.3 % of normal noise is beyond
constexpr double kOutlier = 8;     // standard deviations, chosen

/// @param miss in standard deviations
double huber_weight(double miss) {
  return miss < kFullWeight ? 1 : kFullWeight / miss;
}

double corner_weight(double miss) {
  return miss < kOutlier ? huber_weight(miss) : 0;
}

/// Weighs the measured poses by their corrections relative to those of the other views, not by the
/// noise alone: a fit that has not converged may estimate almost no noise.
void weigh_poses(const ScannerState& state, const NoiseLevels& noise, BoardViews& views) {
  std::vector<double> shifts, turns;
  for (const Vector6d& correction : state.corrections) {
    shifts.push_back(correction.head<3>().norm());
    turns.push_back(correction.tail<3>().norm());
  }
  const double shift = std::max(noise.robot_m, median(shifts) / kMedianLength3);
  const double turn = std::max(noise.robot_rad, median(turns) / kMedianLength3);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const double miss = std::hypot(shifts[i] / shift, turns[i] / turn) / std::sqrt(2.);
    views[i].pose_weight = huber_weight(miss);
  }
}

}  // namespace

void fit(const BoardViews& views, const BoardSurface& surface, const NoiseLevels& noise,
         const FitChoice& choice, ScannerState& state) {
  const ResidualContext context{state, surface, noise};
  Problem problem(context, views, choice);
  problem.solve();
  state = problem.state();
}

void weigh(const ScannerState& state, const BoardSurface& surface, const NoiseLevels& noise,
           const Multiplicities& multiplicities, BoardViews& views) {
  for (std::size_t index = 0; index < views.size(); ++index) {
    BoardView& view = views[index];
    const BoardSight sight = sight_of(state, view, index);
    const std::vector<Eigen::Vector2d> corners = corner_residuals(state, surface, sight, view);
    for (std::size_t i = 0; i < corners.size(); ++i)
      view.weights[i] = corner_weight(corners[i].norm() / noise.corner_px) / multiplicities.corners;
    for (std::size_t laser = 0; laser < state.planes.size(); ++laser) {
      LinePoints& line = view.lines[laser];
      const std::vector<double> points = line_residuals(state, surface, sight, line, laser);
      for (std::size_t i = 0; i < points.size(); ++i)
        line.weights[i] =
            corner_weight(std::abs(points[i]) / noise.line_px[laser]) / multiplicities.lines[laser];
    }
  }
  weigh_poses(state, noise, views);
}

}  // namespace scan_calibration
