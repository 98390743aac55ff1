// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "residuals/normal_equations.h"

namespace scan_calibration {

/// How large each kind of noise is, and how well that is known.
struct NoiseEstimate {
  NoiseLevels levels;
  Eigen::VectorXd freedom;  //!< a group: degrees of freedom it was estimated from; infinite: given
};

/// What the options give, and 0 where the data have to say it.
NoiseLevels given_noise(const CalibrationOptions& options, std::size_t lasers);

/// Variance components (Foerstner 1979): each group's squares over its redundancy, over and over
/// until they stand.
/// @param given as of given_noise()
/// @param most none is taken to be more than this
NoiseEstimate estimate_noise(const NormalEquations& equations, const NoiseLevels& given,
                             const NoiseLevels& most);

/// Bounds that nothing exceeds.
NoiseLevels unbounded_noise(std::size_t lasers);

/// No noise is taken to be less than this: no robot is better than 0.01 mm and 0.01 mrad.
NoiseLevels least_noise(std::size_t lasers);

}  // namespace scan_calibration
