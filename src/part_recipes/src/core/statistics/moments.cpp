// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "statistics/moments.h"

#include <cmath>

namespace part_recipes {

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values)
    sum += value - values.front();
  return values.front() + sum / static_cast<double>(values.size());
}

double standard_deviation_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values)
    sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

}  // namespace part_recipes
