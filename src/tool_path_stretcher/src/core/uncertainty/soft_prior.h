// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCore>

#include "uncertainty/assumptions.h"

namespace tool_path_stretcher {

/// What is assumed of a graph's unknowns: that its links are strained no farther than they were
/// seen to be, each for itself, and besides the whole part in a smooth deformation, a polynomial of
/// degree two. Were each link independent of all others alone, hundreds of them would hold what
/// strains them all alike. Of a smooth deformation all links together are one observation.
class SoftPrior {
 public:
  SoftPrior() = default;

  /// @param known of the pose and the scale, from before
  /// @param rigid of the links
  /// @param modes of the unknowns, a column for each smooth deformation; none: links alone
  /// @param links how many there are
  SoftPrior(const NormalEquations& known, const NormalEquations& rigid,
            const Eigen::MatrixXd& modes, std::size_t links);

  /// The inverse of the covariance of all unknowns, and what it pulls at.
  NormalEquations equations() const;

  /// The quadratic form of that inverse.
  /// @param motions of the unknowns, one in each column
  Eigen::Matrix3d held(const Eigen::Matrix<double, Eigen::Dynamic, 3>& motions) const;

 private:
  Eigen::SparseMatrix<double> stiff_;  // of links, pose and scale
  Eigen::MatrixXd give_;  // a row for each smooth mode: the inverse is stiff - give^T give
  Eigen::VectorXd right_side_;
};

/// How smooth deformations move the unknowns of a graph, a column for each: polynomials of degree
/// two, without turn and shift of the whole. Some move no node, or move them as another does.
Eigen::MatrixXd smooth_modes(const DeformationGraph& graph);

}  // namespace tool_path_stretcher
