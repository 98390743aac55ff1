// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/statistics.h"

#include <fmt/core.h>

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
  constexpr double kMinValue = 1e-300;  // a perfect fit has a logarithm too
  std::vector<double> logarithms, distances;
  for (const double value : values)
    logarithms.push_back(std::log(std::max(value, kMinValue)));
  const double middle = median(logarithms);
  for (const double logarithm : logarithms)
    distances.push_back(std::abs(logarithm - middle));
  const double limit =
      std::max(deviations * kDeviationPerMedian * median(distances), std::log(factor));
  std::vector<bool> result;
  for (const double logarithm : logarithms)
    result.push_back(logarithm - middle > limit);
  return result;
}

std::string figure(double value, const char* unit) {
  const bool plain = std::abs(value) >= 99.5 && std::abs(value) < 1e6;
  return plain ? fmt::format("{:.0f}{}", value, unit) : fmt::format("{:.3g}{}", value, unit);
}

std::string millimetres(double length) {
  return figure(length * 1e3, " mm");
}

std::string degrees(double angle) {
  return figure(angle * 180 / M_PI, " deg");
}

std::string share(std::size_t part, std::size_t whole) {
  return fmt::format("{} of {}", part, whole);
}

}  // namespace scan_calibration
