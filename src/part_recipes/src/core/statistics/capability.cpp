// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "statistics/capability.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "statistics/individuals_chart.h"
#include "statistics/moments.h"
#include "statistics/western_electric.h"

namespace part_recipes {
namespace {

constexpr double kConfidence = 0.95;  // share of samples whose interval holds the true value
constexpr double kTail = (1 - kConfidence) / 2;

}  // namespace

std::string to_string(NoCapability reason) {
  switch (reason) {
    case NoCapability::kNoTolerance:
      return "no_tolerance";
    case NoCapability::kToleranceChanged:
      return "tolerance_changed";
    case NoCapability::kTooFewValues:
      return "too_few_values";
    case NoCapability::kNotInControl:
      return "not_in_control";
    case NoCapability::kNoSpread:
      break;
  }
  return "no_spread";
}

std::string in_words(NoCapability reason) {
  switch (reason) {
    case NoCapability::kNoTolerance:
      return "no tolerance is given for it";
    case NoCapability::kToleranceChanged:
      return "the tolerance changed between the runs; choose runs of one tolerance with --since";
    case NoCapability::kTooFewValues:
      return "fewer than " + std::to_string(kCapabilityValues) + " values";
    case NoCapability::kNotInControl:
      return "not in control: fewer than " + std::to_string(kCapabilityValues) +
             " values since a rule was broken; find the cause, then choose the runs since with "
             "--since";
    case NoCapability::kNoSpread:
      break;
  }
  return "all values are the same";
}

Capability capability_of(std::size_t count, double mean, double standard_deviation,
                         const Interval& tolerance) {
  Capability result;
  result.count = count;
  result.mean = mean;
  result.standard_deviation = standard_deviation;
  result.cp = (tolerance.upper - tolerance.lower) / (6 * standard_deviation);
  result.cpk = std::min(tolerance.upper - mean, mean - tolerance.lower) / (3 * standard_deviation);
  const double freedom = static_cast<double>(count) - 1;
  const boost::math::chi_squared spread(freedom);
  const auto at = [&](double probability) {
    return result.cp * std::sqrt(boost::math::quantile(spread, probability) / freedom);
  };
  result.cp_interval = {at(kTail), at(1 - kTail)};
  const double z = boost::math::quantile(boost::math::normal(), 1 - kTail);
  const double half =
      z * std::sqrt(1 / (9 * static_cast<double>(count)) + result.cpk * result.cpk / (2 * freedom));
  result.cpk_interval = {result.cpk - half, result.cpk + half};
  return result;
}

std::variant<Capability, NoCapability> capability(const std::vector<double>& values,
                                                  const std::optional<Interval>& tolerance) {
  if (!tolerance || tolerance->upper <= tolerance->lower) return NoCapability::kNoTolerance;
  if (values.size() < kCapabilityValues) return NoCapability::kTooFewValues;
  const auto chart = individuals_chart(values);
  if (chart->sigma == 0) return NoCapability::kNoSpread;
  const auto breaks = western_electric(values, chart->mean, chart->sigma);
  const std::size_t first = breaks.empty() ? 0 : breaks.back().at + 1;
  if (values.size() - first < kCapabilityValues) return NoCapability::kNotInControl;
  const std::vector<double> calm(values.begin() + static_cast<std::ptrdiff_t>(first), values.end());
  const double deviation = standard_deviation_of(calm);
  if (deviation == 0) return NoCapability::kNoSpread;
  Capability result = capability_of(calm.size(), mean_of(calm), deviation, *tolerance);
  result.first = first;
  return result;
}

}  // namespace part_recipes
