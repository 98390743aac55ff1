// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace part_recipes {

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

DeviationStatistics statistics_of(const std::vector<double>& deviations, double tolerance) {
  std::vector<double> known;
  std::copy_if(deviations.begin(), deviations.end(), std::back_inserter(known),
               [](double value) { return std::isfinite(value); });
  DeviationStatistics statistics;
  statistics.points = deviations.size();
  statistics.unknown = deviations.size() - known.size();
  if (known.empty()) return statistics;
  const auto count = static_cast<double>(known.size());
  statistics.rms =
      std::sqrt(std::inner_product(known.begin(), known.end(), known.begin(), 0.0) / count);
  const auto [least, most] = std::minmax_element(known.begin(), known.end());
  statistics.min = *least;
  statistics.max = *most;
  const auto good = std::count_if(known.begin(), known.end(),
                                  [&](double value) { return std::abs(value) <= tolerance; });
  statistics.within_tolerance = static_cast<double>(good) / count;
  statistics.median = median_of(std::move(known));
  return statistics;
}

}  // namespace part_recipes
