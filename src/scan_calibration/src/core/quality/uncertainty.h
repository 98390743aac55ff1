// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "estimate/joint_estimate.h"

namespace scan_calibration {

/// How well the shared unknowns are known.
struct Knowledge {
  explicit Knowledge(const JointEstimate& estimate, const BoardSurface& surface);

  /// Standard deviation of a quantity: root of the summed variances of its components. It is the
  /// larger of the one from the noise and the one from leaving out a view at a time (internal and
  /// external uncertainty, Birge 1932), each widened by Student's t so that three of them cover as
  /// much as three standard deviations of a normal distribution.
  /// @param rows derivative of each component by the shared unknowns
  double deviation(const Eigen::MatrixXd& rows) const;

  Layout layout;
  Eigen::MatrixXd information;
  Eigen::MatrixXd covariance;              //!< from the noise
  Eigen::MatrixXd jackknife;               //!< from leaving out a view at a time
  std::vector<Eigen::MatrixXd> by_source;  //!< parts of `covariance`, by kind of noise
  Eigen::VectorXd freedom;                 //!< degrees of freedom of each kind
  double views = 0;
};

/// Derivative of a vector by the shared unknowns, by central differences over a tenth of the
/// unknowns' standard deviations.
Eigen::MatrixXd derivative(const ScannerState& state, const Knowledge& knowledge,
                           const std::function<Eigen::VectorXd(const ScannerState&)>& quantity);

/// Value, deviation and unit of every parameter of the model, and their covariance, scaled to these
/// deviations.
/// @param lasers of the planes
void state_parameters(const ScannerState& state, const Knowledge& knowledge,
                      const std::vector<std::string>& lasers,
                      std::vector<EstimatedParameter>& parameters, Eigen::MatrixXd& covariance);

}  // namespace scan_calibration
