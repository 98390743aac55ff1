// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "alignment/refinement/pairing.h"
#include "tool_path_stretcher/prior.h"

namespace tool_path_stretcher {

using Vector7d = Eigen::Matrix<double, 7, 1>;
using Matrix7d = Eigen::Matrix<double, 7, 7>;

/// Normal equations of a small similarity about `centre`: rotation, shift, relative growth.
class MotionEquations {
 public:
  explicit MotionEquations(const Eigen::Vector3d& centre) : centre_(centre) {}

  /// Weights each constraint by the deviation [m]; errors far beyond it do not count.
  void add(const PointConstraints& constraints, double deviation);

  /// Adds the prior knowledge of the object's scale, which is now `current`.
  void add_prior(const ScalePrior& prior, double current);

  /// The motion that meets the constraints best; none, if it is not finite.
  Vector7d solve() const;

  /// What the constraints resist: of the squared errors, half of the second derivative.
  const Matrix7d& matrix() const { return matrix_; }

 private:
  Eigen::Vector3d centre_;
  Matrix7d matrix_ = Matrix7d::Zero();
  Vector7d right_side_ = Vector7d::Zero();
  bool fixed_scale_ = false;
};

/// The similarity after a motion about `centre` that MotionEquations found.
Similarity moved(const Similarity& similarity, const Eigen::Vector3d& centre, const Vector7d& step);

}  // namespace tool_path_stretcher
