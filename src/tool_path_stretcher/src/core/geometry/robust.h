// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace tool_path_stretcher {

/// The value below which `share` of the values lie; 0 where there is none.
double quantile(std::vector<double> values, double share);

/// Standard deviation of normal noise about zero, from the median of its magnitudes.
double robust_deviation(std::vector<double> residuals);

/// Weight of Tukey's biweight for least squares: 1 at zero, 0 from `cut` on.
double tukey_weight(double residual, double cut);

constexpr double kTukeyCut = 4.685;  // standard deviations: 95 % efficient for normal noise

}  // namespace tool_path_stretcher
