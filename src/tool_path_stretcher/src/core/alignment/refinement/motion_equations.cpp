// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alignment/refinement/motion_equations.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/robust.h"

namespace tool_path_stretcher {

void MotionEquations::add(const PointConstraints& constraints, double deviation) {
  for (const PointConstraint& constraint : constraints) {
    const double weight =
        tukey_weight(constraint.error, kTukeyCut * deviation) / (deviation * deviation);
    if (weight == 0) continue;
    const Eigen::Vector3d arm = constraint.point - centre_;
    Vector7d row;
    row << arm.cross(constraint.direction), constraint.direction, arm.dot(constraint.direction);
    matrix_ += weight * row * row.transpose();
    right_side_ += weight * constraint.error * row;
  }
}

void MotionEquations::add_prior(const ScalePrior& prior, double current) {
  fixed_scale_ = prior.is_fixed();
  if (!prior.is_known() || fixed_scale_) return;
  const double deviation = prior.deviation / current;
  matrix_(6, 6) += 1 / (deviation * deviation);
  right_side_[6] += std::log(prior.value / current) / (deviation * deviation);
}

Vector7d MotionEquations::solve() const {
  constexpr double kDamping = 1e-9;  // pins what the surfaces do not show
  Matrix7d matrix = matrix_;
  for (int i = 0; i < 7; ++i)
    matrix(i, i) += kDamping * matrix_(i, i) + 1e-12;
  Vector7d step = Vector7d::Zero();
  if (fixed_scale_) {
    step.head<6>() = matrix.topLeftCorner<6, 6>().ldlt().solve(right_side_.head<6>());
  } else {
    step = matrix.ldlt().solve(right_side_);
  }
  return step.allFinite() ? step : Vector7d::Zero();
}

Similarity moved(const Similarity& similarity, const Eigen::Vector3d& centre,
                 const Vector7d& step) {
  const double angle = step.head<3>().norm();
  const Eigen::Matrix3d turn =
      angle > 0 ? Eigen::AngleAxisd(angle, step.head<3>() / angle).toRotationMatrix()
                : Eigen::Matrix3d::Identity();
  constexpr double kMaxGrowth = 0.1;  // of the scale in a step; chosen
  const double growth = std::exp(std::clamp(step[6], -kMaxGrowth, kMaxGrowth));
  Similarity result;
  result.scale = growth * similarity.scale;
  result.rotation = Eigen::Quaterniond(turn * similarity.rotation).normalized().toRotationMatrix();
  result.translation =
      growth * (turn * (similarity.translation - centre)) + centre + step.segment<3>(3);
  return result;
}

}  // namespace tool_path_stretcher
