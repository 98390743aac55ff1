// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "residuals/joint_fit.h"

namespace scan_calibration {

/// Indices of the unknowns that all views share in the normal equations; -1: not estimated. Poses
/// are small motions, planes normal / distance.
struct Layout {
  Layout(const FitChoice& choice, std::size_t laser_count);

  Eigen::Index camera = -1;
  Eigen::Index flange_to_camera = -1;
  Eigen::Index base_to_board = -1;
  Eigen::Index bend = -1;
  std::vector<Eigen::Index> planes;
  Eigen::Index size = 0;
};

/// Sources of noise, in the order of the groups of residuals.
struct NoiseGroups {
  explicit NoiseGroups(const NoiseLevels& noise) : lasers(noise.line_px.size()) {}

  std::size_t corners() const { return 0; }
  std::size_t line(std::size_t laser) const { return 1 + laser; }
  std::size_t robot_position() const { return 1 + lasers; }
  std::size_t robot_rotation() const { return 2 + lasers; }
  std::size_t count() const { return 3 + lasers; }

  std::size_t lasers;
};

/// Deviations by group.
Eigen::VectorXd noise_vector(const NoiseLevels& noise);
NoiseLevels noise_levels(const Eigen::VectorXd& deviations);

/// Squares of one group of residuals of one view, to second order in its flange's correction (the
/// first six unknowns) and the shared unknowns.
struct GroupSquares {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd gradient;
  double squares = 0;
  double count = 0;  //!< of residuals, by their weights
};

/// One view's groups.
using ViewSquares = std::vector<GroupSquares>;

/// The least-squares problem about a state, group by group, so that it can be weighted anew or a
/// view left out at no cost.
struct NormalEquations {
  NormalEquations(const BoardViews& views, const BoardSurface& surface, const NoiseLevels& noise,
                  const FitChoice& choice, const ScannerState& state);

  Layout layout;
  std::vector<ViewSquares> views;  //!< over the noise given
  GroupSquares lens;               //!< of the prior knowledge of the lens; shared unknowns only
  Eigen::VectorXd noise;           //!< by which the groups were divided
};

/// A view's squares with its flange's correction eliminated.
struct ReducedView {
  Eigen::MatrixXd information;  //!< about the shared unknowns
  Eigen::VectorXd gradient;
  Matrix6d inverse;          //!< of the correction's own block
  Eigen::MatrixXd coupling;  //!< correction's block, inverted, times its block with the shared
  Vector6d own;              //!< inverse times the correction's gradient
};

/// @param factors by which the squares of each group are multiplied
ReducedView reduce(const ViewSquares& squares, const Eigen::VectorXd& factors);

/// All views, reduced and added up.
struct ReducedSystem {
  ReducedSystem(const NormalEquations& equations, const Eigen::VectorXd& noise);

  std::vector<ReducedView> views;
  Eigen::VectorXd factors;
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd covariance;  //!< of the shared unknowns
};

/// The inverse of a positive matrix whose unknowns may have any scale.
/// @throw scan_cell_common::UnusableInput if it is singular
Eigen::MatrixXd inverse_of_information(const Eigen::MatrixXd& information);

/// Covariance of a view's correction and the shared unknowns together.
Eigen::MatrixXd joint_covariance(const ReducedView& view, const Eigen::MatrixXd& covariance);

}  // namespace scan_calibration
