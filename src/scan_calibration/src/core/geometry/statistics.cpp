// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace scan_calibration {

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

std::vector<bool> outstanding(const std::vector<double>& values, double deviations, double factor) {
  constexpr double kLeast = 1e-300;     // of a perfect fit
  constexpr double kGaussian = 1.4826;  // deviation over median absolute deviation
  std::vector<double> logarithms, distances;
  for (const double value : values)
    logarithms.push_back(std::log(std::max(value, kLeast)));
  const double middle = median(logarithms);
  for (const double logarithm : logarithms)
    distances.push_back(std::abs(logarithm - middle));
  const double limit = std::max(deviations * kGaussian * median(distances), std::log(factor));
  std::vector<bool> result;
  for (const double logarithm : logarithms)
    result.push_back(logarithm - middle > limit);
  return result;
}

std::string figure(double value, const char* unit) {
  char text[48];
  const bool plain = std::abs(value) >= 99.5 && std::abs(value) < 1e6;
  std::snprintf(text, sizeof(text), plain ? "%.0f%s" : "%.3g%s", value, unit);
  return text;
}

std::string share(std::size_t part, std::size_t whole) {
  return std::to_string(part) + " of " + std::to_string(whole);
}

}  // namespace scan_calibration
