// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/robust.h"

#include <algorithm>
#include <cmath>

namespace tool_path_stretcher {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * last);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double robust_deviation(std::vector<double> residuals) {
  for (double& residual : residuals)
    residual = std::abs(residual);
  return 1.4826 * quantile(std::move(residuals), 0.5);
}

double tukey_weight(double residual, double cut) {
  const double share = residual / cut;
  if (std::abs(share) >= 1) return 0;
  return (1 - share * share) * (1 - share * share);
}

}  // namespace tool_path_stretcher
