// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCore>

#include "uncertainty/assumptions.h"

namespace tool_path_stretcher {

/// Assumptions about a graph's unknowns: links are strained no more than they were seen to be, each
/// independently, and in addition the whole part in a smooth deformation (a polynomial of degree
/// two), of which all links together are one observation. If the links were only independent,
/// hundreds of them would hold a strain that affects them all alike.
class SoftPrior {
 public:
  SoftPrior() = default;

  /// @param known prior of the pose and the scale
  /// @param rigid stiffness of the links
  /// @param modes of the unknowns, one column per smooth deformation; empty: links alone
  /// @param links number of links
  SoftPrior(const NormalEquations& known, const NormalEquations& rigid,
            const Eigen::MatrixXd& modes, std::size_t links);

  /// The inverse of the covariance of all unknowns, and the right side.
  NormalEquations equations() const;

  /// The quadratic form of that inverse.
  /// @param motions of the unknowns, one per column
  Eigen::Matrix3d held(const Eigen::Matrix<double, Eigen::Dynamic, 3>& motions) const;

 private:
  Eigen::SparseMatrix<double> stiff_;  // of links, pose and scale
  Eigen::MatrixXd give_;  // one row per smooth mode: the inverse is stiff - give^T give
  Eigen::VectorXd right_side_;
};

/// The motion of a graph's unknowns under smooth deformations, one column each: polynomials of
/// degree two, without rotation and shift of the whole. Some move no node, or move nodes like
/// another one.
Eigen::MatrixXd smooth_modes(const DeformationGraph& graph);

}  // namespace tool_path_stretcher
