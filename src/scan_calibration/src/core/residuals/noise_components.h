// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "residuals/normal_equations.h"

namespace scan_calibration {

/// Size of each kind of noise, and how well it is known.
struct NoiseEstimate {
  NoiseLevels levels;
  Eigen::VectorXd freedom;  //!< per group: degrees of freedom; infinite where the noise is given
};

/// The noise given by the options; 0 if it has to be estimated from the data.
NoiseLevels given_noise(const CalibrationOptions& options, std::size_t lasers);

/// Variance components (Foerstner 1979): each group's squares over its redundancy, repeated until
/// they no longer change.
/// @param given as returned by given_noise()
NoiseEstimate estimate_noise(const NormalEquations& equations, const NoiseLevels& given);

/// Lower limits: no robot is better than 0.01 mm and 0.01 mrad.
NoiseLevels min_noise(std::size_t lasers);

}  // namespace scan_calibration
