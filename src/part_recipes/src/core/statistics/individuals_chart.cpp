// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "statistics/individuals_chart.h"

#include <cmath>

#include "statistics/moments.h"

namespace part_recipes {
namespace {

constexpr double kD2 = 1.128;  // mean range of two normal values / sigma: NIST e-Handbook 6.3.2.2
constexpr double kD4 = 3.267;  // upper limit of ranges of two / their mean: NIST e-Handbook 6.3.2.2

}  // namespace

std::optional<IndividualsChart> individuals_chart(const std::vector<double>& values) {
  if (values.size() < 2) return std::nullopt;
  IndividualsChart chart;
  chart.count = values.size();
  chart.mean = mean_of(values);
  for (std::size_t i = 1; i < values.size(); ++i)
    chart.moving_ranges.push_back(std::abs(values[i] - values[i - 1]));
  chart.moving_range_mean = mean_of(chart.moving_ranges);
  chart.moving_range_upper = kD4 * chart.moving_range_mean;
  chart.sigma = chart.moving_range_mean / kD2;
  chart.lower = chart.mean - 3 * chart.sigma;
  chart.upper = chart.mean + 3 * chart.sigma;
  for (std::size_t i = 0; i < chart.moving_ranges.size(); ++i) {
    if (chart.moving_ranges[i] > chart.moving_range_upper) chart.wide_ranges.push_back(i + 1);
  }
  return chart;
}

}  // namespace part_recipes
