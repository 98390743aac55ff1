// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "estimate/joint_estimate.h"

namespace scan_calibration {

/// How well the shared unknowns are known.
struct Knowledge {
  explicit Knowledge(const JointEstimate& estimate, const BoardSurface& surface);

  /// Standard deviation of a quantity: root of the sum of the variances of its components. The
  /// larger of what the noise says and what leaving out a view at a time shows (internal and
  /// external uncertainty, Birge 1932), each widened by Student's t so that three deviations hold
  /// what three hold of a normal distribution.
  /// @param rows derivative of each component by the shared unknowns
  double deviation(const Eigen::MatrixXd& rows) const;

  Layout layout;
  Eigen::MatrixXd information;
  Eigen::MatrixXd covariance;              //!< by the noise
  Eigen::MatrixXd jackknife;               //!< by leaving out a view at a time
  std::vector<Eigen::MatrixXd> by_source;  //!< parts of `covariance` that a kind of noise brings
  Eigen::VectorXd freedom;                 //!< of each kind
  double views = 0;
};

/// Derivative of a vector that depends on the shared unknowns, by central differences over a tenth
/// of their deviations.
Eigen::MatrixXd derivative(const ScannerState& state, const Knowledge& knowledge,
                           const std::function<Eigen::VectorXd(const ScannerState&)>& quantity);

/// Value, deviation and unit of every number of the model, and their covariance, scaled to the
/// deviations.
/// @param lasers whose planes the state holds
void state_parameters(const ScannerState& state, const Knowledge& knowledge,
                      const std::vector<std::string>& lasers,
                      std::vector<EstimatedParameter>& parameters, Eigen::MatrixXd& covariance);

}  // namespace scan_calibration
