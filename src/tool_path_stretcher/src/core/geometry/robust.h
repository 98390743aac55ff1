// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace tool_path_stretcher {

/// The value below which `share` of the values lie; 0 if there are no values.
double quantile(std::vector<double> values, double share);

/// Standard deviation of zero-mean normal noise, from the median of the magnitudes.
double robust_deviation(std::vector<double> residuals);

/// Least-squares weight of Tukey's biweight: 1 at zero, 0 from `cut` on.
double tukey_weight(double residual, double cut);

constexpr double kTukeyCut = 4.685;  // standard deviations: 95 % efficient for normal noise

}  // namespace tool_path_stretcher
