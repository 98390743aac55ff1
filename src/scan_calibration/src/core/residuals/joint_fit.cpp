// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "residuals/joint_fit.h"

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <cmath>
#include <memory>

#include "geometry/statistics.h"
#include "residuals/residuals.h"
#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

/// Motions start from zero and are added to the poses at the end.
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
    options.num_threads = 1;  // several add up in the order of their luck
    options.max_num_iterations = 100;
    options.function_tolerance = 1e-10;
    options.parameter_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    double cost = 0;  // Ceres prints what it cannot begin with
    ceres::Solver::Summary summary;
    const bool possible =
        problem_.Evaluate(ceres::Problem::EvaluateOptions(), &cost, nullptr, nullptr, nullptr);
    if (possible) ceres::Solve(options, &problem_, &summary);
    if (!possible || !summary.IsSolutionUsable()) {
      throw scan_cell_common::UnusableInput(
          "estimate", possible ? summary.message : "the start puts corners behind the camera",
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

  /// The views' corrections are eliminated, in one group; each other block has a group of its own.
  /// Within a group Ceres goes by addresses, which differ from thread to thread, and so would the
  /// last bit.
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

/// @param miss in deviations
double huber(double miss) {
  constexpr double kFull = 3;
  constexpr double kOut = 8;
  if (!(miss < kOut)) return 0;
  return miss < kFull ? 1 : kFull / miss;
}

/// Of the measured poses, by what they miss beside the others: the noise may have been found to be
/// next to nothing by a fit that is not at its end.
void weigh_poses(const ScannerState& state, const NoiseLevels& noise, BoardViews& views) {
  constexpr double kFull = 3;       // of six numbers together, in deviations of one
  constexpr double kChi3 = 1.5382;  // median length of a vector of unit noise
  std::vector<double> shifts, turns;
  for (const Vector6d& correction : state.corrections) {
    shifts.push_back(correction.head<3>().norm());
    turns.push_back(correction.tail<3>().norm());
  }
  const double shift = std::max(noise.robot_m, median(shifts) / kChi3);
  const double turn = std::max(noise.robot_rad, median(turns) / kChi3);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const double miss = std::hypot(shifts[i] / shift, turns[i] / turn) / std::sqrt(2.);
    views[i].pose_weight = miss < kFull ? 1 : kFull / miss;
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
      view.weights[i] = huber(corners[i].norm() / noise.corner_px) / multiplicities.corners;
    for (std::size_t laser = 0; laser < state.planes.size(); ++laser) {
      LinePoints& line = view.lines[laser];
      const std::vector<double> points = line_residuals(state, surface, sight, line, laser);
      for (std::size_t i = 0; i < points.size(); ++i)
        line.weights[i] =
            huber(std::abs(points[i]) / noise.line_px[laser]) / multiplicities.lines[laser];
    }
  }
  weigh_poses(state, noise, views);
}

}  // namespace scan_calibration
