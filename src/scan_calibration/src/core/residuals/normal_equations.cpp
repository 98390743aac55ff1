// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "residuals/normal_equations.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <numeric>

#include "residuals/residuals.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

constexpr Eigen::Index kOwn = 6;  // a correction's numbers stand before the shared ones
constexpr Eigen::Index kNowhere = -1;

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Residuals and their derivatives, the columns as in the normal equations.
struct Linearised {
  /// @param columns of each parameter block
  Linearised(const ceres::CostFunction& cost, const std::vector<const double*>& parameters,
             const std::vector<Eigen::Index>& columns, Eigen::Index size)
      : residuals(cost.num_residuals()), jacobian(RowMajor::Zero(cost.num_residuals(), size)) {
    std::vector<RowMajor> blocks;
    for (const int width : cost.parameter_block_sizes())
      blocks.emplace_back(cost.num_residuals(), width);
    std::vector<double*> pointers;
    for (RowMajor& block : blocks)
      pointers.push_back(block.data());
    if (!cost.Evaluate(parameters.data(), residuals.data(), pointers.data())) {
      throw scan_cell_common::UnusableInput("estimate", "a corner lies behind the camera",
                                            "check the views and poses of the session");
    }
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (columns[i] != kNowhere) jacobian.middleCols(columns[i], blocks[i].cols()) = blocks[i];
    }
  }

  GroupSquares squares(Eigen::Index first, Eigen::Index count, double weights) const {
    const auto rows = jacobian.middleRows(first, count);
    const auto values = residuals.segment(first, count);
    GroupSquares result;
    result.matrix = rows.transpose() * rows;
    result.gradient = rows.transpose() * values;
    result.squares = values.squaredNorm();
    result.count = weights;
    return result;
  }

  GroupSquares squares(double weights) const { return squares(0, residuals.size(), weights); }

  Eigen::VectorXd residuals;
  RowMajor jacobian;
};

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.);
}

GroupSquares none(Eigen::Index size) {
  return {Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size), 0, 0};
}

Eigen::Index after_own(Eigen::Index shared) {
  return shared == kNowhere ? kNowhere : kOwn + shared;
}

ViewSquares squares_of(const ResidualContext& context, const BoardView& view, std::size_t index,
                       const FitChoice& choice, const Layout& layout) {
  const NoiseGroups groups(context.noise);
  const Eigen::Index size = kOwn + layout.size;
  ViewSquares result(groups.count(), none(size));
  const ScannerState& state = context.reference;
  const Vector6d rest = Vector6d::Zero();
  std::vector<const double*> parameters = {state.camera.data(), rest.data(), rest.data(),
                                           state.bend.data(), state.corrections[index].data()};
  std::vector<Eigen::Index> columns = {after_own(layout.camera), after_own(layout.flange_to_camera),
                                       after_own(layout.base_to_board), after_own(layout.bend), 0};
  result[groups.corners()] = Linearised(CornerResiduals(context, view), parameters, columns, size)
                                 .squares(2 * sum(view.weights));
  if (!choice.robot) return result;
  const Linearised robot(RobotResiduals(context, view), {parameters.back()}, {0}, size);
  result[groups.robot_position()] = robot.squares(0, 3, 3 * view.pose_weight);
  result[groups.robot_rotation()] = robot.squares(3, 3, 3 * view.pose_weight);
  parameters.push_back(nullptr);
  columns.push_back(kNowhere);
  for (std::size_t laser = 0; laser < view.lines.size(); ++laser) {
    if (view.lines[laser].pixels.empty()) continue;
    parameters.back() = state.planes[laser].data();
    columns.back() = after_own(layout.planes[laser]);
    result[groups.line(laser)] =
        Linearised(LineResiduals(context, view, index, laser), parameters, columns, size)
            .squares(sum(view.lines[laser].weights));
  }
  return result;
}

}  // namespace

Layout::Layout(const FitChoice& choice, std::size_t laser_count) {
  const auto place = [this](Eigen::Index& at, Eigen::Index width) {
    at = size;
    size += width;
  };
  if (choice.camera) place(camera, 9);
  if (choice.camera && choice.robot) place(flange_to_camera, 6);
  if (choice.robot) place(base_to_board, 6);
  if (choice.bend) place(bend, 3);
  planes.assign(laser_count, kNowhere);
  for (Eigen::Index& plane : planes)
    if (choice.robot) place(plane, 3);
}

Eigen::VectorXd noise_vector(const NoiseLevels& noise) {
  const NoiseGroups groups(noise);
  Eigen::VectorXd result(groups.count());
  const auto at = [&](std::size_t group) -> double& {
    return result[static_cast<Eigen::Index>(group)];
  };
  at(groups.corners()) = noise.corner_px;
  for (std::size_t laser = 0; laser < groups.lasers; ++laser)
    at(groups.line(laser)) = noise.line_px[laser];
  at(groups.robot_position()) = noise.robot_m;
  at(groups.robot_rotation()) = noise.robot_rad;
  return result;
}

NoiseLevels noise_levels(const Eigen::VectorXd& deviations) {
  const Eigen::Index lasers = deviations.size() - 3;
  NoiseLevels noise;
  noise.corner_px = deviations[0];
  for (Eigen::Index laser = 0; laser < lasers; ++laser)
    noise.line_px.push_back(deviations[1 + laser]);
  noise.robot_m = deviations[1 + lasers];
  noise.robot_rad = deviations[2 + lasers];
  return noise;
}

NormalEquations::NormalEquations(const BoardViews& seen, const BoardSurface& surface,
                                 const NoiseLevels& levels, const FitChoice& choice,
                                 const ScannerState& state)
    : layout(choice, state.planes.size()), noise(noise_vector(levels)) {
  const ResidualContext context{state, surface, levels};
  for (std::size_t i = 0; i < seen.size(); ++i)
    views.push_back(squares_of(context, seen[i], i, choice, layout));
  const LensResiduals prior(context, choice.square_pixels);
  lens = Linearised(prior, {state.camera.data()}, {layout.camera}, layout.size).squares(0);
}

ReducedView reduce(const ViewSquares& squares, const Eigen::VectorXd& factors) {
  const Eigen::Index size = squares.front().matrix.rows();
  GroupSquares all = none(size);
  for (std::size_t group = 0; group < squares.size(); ++group) {
    const double factor = factors[static_cast<Eigen::Index>(group)];
    all.matrix += factor * squares[group].matrix;
    all.gradient += factor * squares[group].gradient;
  }
  const Eigen::Index shared = size - kOwn;
  const Eigen::LDLT<Matrix6d> own(all.matrix.topLeftCorner<kOwn, kOwn>());
  ReducedView result;
  result.inverse = own.solve(Matrix6d::Identity());
  result.coupling = own.solve(all.matrix.topRightCorner(kOwn, shared));
  result.own = own.solve(all.gradient.head<kOwn>());
  result.information = all.matrix.bottomRightCorner(shared, shared) -
                       all.matrix.bottomLeftCorner(shared, kOwn) * result.coupling;
  result.gradient =
      all.gradient.tail(shared) - all.matrix.bottomLeftCorner(shared, kOwn) * result.own;
  return result;
}

ReducedSystem::ReducedSystem(const NormalEquations& equations, const Eigen::VectorXd& noise)
    : factors(equations.noise.cwiseQuotient(noise).cwiseAbs2()),
      information(equations.lens.matrix),
      gradient(equations.lens.gradient) {
  for (const ViewSquares& squares : equations.views) {
    views.push_back(reduce(squares, factors));
    information += views.back().information;
    gradient += views.back().gradient;
  }
  covariance = inverse_of_information(information);
}

Eigen::MatrixXd inverse_of_information(const Eigen::MatrixXd& information) {
  const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::LDLT<Eigen::MatrixXd> factors((scaled + scaled.transpose()) / 2);
  if (!scaled.allFinite() || !factors.isPositive() || !(factors.vectorD().minCoeff() > 0)) {
    throw scan_cell_common::UnusableInput(
        "calibration session", "leaves a parameter of the scanner undetermined",
        "add views that differ in tilt, distance and place in the image");
  }
  const Eigen::MatrixXd inverse =
      factors.solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
  return scale.asDiagonal() * ((inverse + inverse.transpose()) / 2) * scale.asDiagonal();
}

Eigen::MatrixXd joint_covariance(const ReducedView& view, const Eigen::MatrixXd& covariance) {
  const Eigen::Index shared = covariance.rows();
  Eigen::MatrixXd result(kOwn + shared, kOwn + shared);
  const Eigen::MatrixXd crossed = -view.coupling * covariance;
  result.topLeftCorner<kOwn, kOwn>() = view.inverse - crossed * view.coupling.transpose();
  result.topRightCorner(kOwn, shared) = crossed;
  result.bottomLeftCorner(shared, kOwn) = crossed.transpose();
  result.bottomRightCorner(shared, shared) = covariance;
  return result;
}

}  // namespace scan_calibration
