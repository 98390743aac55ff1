// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "teaching/tool_tip.h"

#include <fmt/core.h>

#include <Eigen/SVD>
#include <cmath>

#include "geometry/statistics.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

using scan_cell_common::UnusableInput;

constexpr Eigen::Index kUnknowns = 6;  // tip and fixed point

struct Equations {
  Eigen::MatrixXd matrix;  // rows [R_i, -1]
  Eigen::VectorXd right;   // -t_i
};

Equations equations(const std::vector<Eigen::Isometry3d>& flange) {
  const auto rows = static_cast<Eigen::Index>(3 * flange.size());
  Equations result{Eigen::MatrixXd(rows, kUnknowns), Eigen::VectorXd(rows)};
  for (std::size_t i = 0; i < flange.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(3 * i);
    result.matrix.block<3, 3>(row, 0) = flange[i].linear();
    result.matrix.block<3, 3>(row, 3) = -Eigen::Matrix3d::Identity();
    result.right.segment<3>(row) = -flange[i].translation();
  }
  return result;
}

void check_poses(const std::vector<Eigen::Isometry3d>& flange) {
  if (flange.size() < 3) {
    throw UnusableInput("poses of the tool", std::to_string(flange.size()),
                        "touch the fixed point from at least three orientations");
  }
  for (std::size_t i = 0; i < flange.size(); ++i) {
    if (!flange[i].matrix().allFinite()) {
      throw UnusableInput(fmt::format("pose {} of the tool", i + 1), "not finite",
                          "teach it again");
    }
  }
}

/// Standard deviations of the tip from the residuals' variance and the covariance (A^T A)^-1.
Eigen::Vector3d deviation_of_tip(const Eigen::JacobiSVD<Eigen::MatrixXd>& svd, double squares,
                                 Eigen::Index equations) {
  const double variance = squares / static_cast<double>(equations - kUnknowns);
  const Eigen::MatrixXd scaled = svd.matrixV() * svd.singularValues().cwiseInverse().asDiagonal();
  return (variance * scaled.rowwise().squaredNorm()).cwiseSqrt().head<3>();
}

}  // namespace

ToolTip tool_tip_from_poses(const std::vector<Eigen::Isometry3d>& flange,
                            const ToolTipLimits& limits) {
  check_poses(flange);
  const Equations system = equations(flange);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(system.matrix,
                                              Eigen::ComputeThinU | Eigen::ComputeThinV);
  ToolTip result;
  result.condition = svd.singularValues()[0] / svd.singularValues()[kUnknowns - 1];
  if (!(result.condition <= limits.max_condition)) {
    throw UnusableInput("orientations of the tool",
                        "condition number " + figure(result.condition, ""),
                        fmt::format("tilt the tool further, about two axes; at most {} is usable",
                                    figure(limits.max_condition, "")));
  }
  const Eigen::VectorXd solution = svd.solve(system.right);
  result.tip = solution.head<3>();
  result.fixed_point = solution.tail<3>();

  double squares = 0;
  result.worst_residual = -1;
  for (std::size_t i = 0; i < flange.size(); ++i) {
    const double residual = (flange[i] * result.tip - result.fixed_point).norm();
    squares += residual * residual;
    if (residual > result.worst_residual) {
      result.worst_residual = residual;
      result.worst_pose = i;
    }
  }
  result.rms = std::sqrt(squares / static_cast<double>(flange.size()));
  result.deviation = deviation_of_tip(svd, squares, system.right.size());
  if (result.worst_residual > limits.max_residual) {
    throw UnusableInput(
        fmt::format("pose {} of the tool", result.worst_pose + 1),
        "misses the fixed point by " + millimetres(result.worst_residual),
        fmt::format("teach it again; at most {} is usable", millimetres(limits.max_residual)));
  }
  return result;
}

}  // namespace scan_calibration
