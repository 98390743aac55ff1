// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "residuals/normal_equations.h"

namespace scan_calibration {

/// How large each kind of noise is, and how well that is known.
struct NoiseEstimate {
  NoiseLevels levels;
  Eigen::VectorXd freedom;  //!< per group: degrees of freedom; infinite where the noise is given
};

/// The noise that the options give; 0 where it has to be estimated from the data.
NoiseLevels given_noise(const CalibrationOptions& options, std::size_t lasers);

/// Variance components (Foerstner 1979): each group's squares over its redundancy, repeated until
/// they no longer change.
/// @param given as returned by given_noise()
NoiseEstimate estimate_noise(const NormalEquations& equations, const NoiseLevels& given);

/// Lower limits: no robot is better than 0.01 mm and 0.01 mrad.
NoiseLevels min_noise(std::size_t lasers);

}  // namespace scan_calibration
