// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace part_recipes {

/// The middle value, or the mean of the two in the middle.
/// @param values at least one
double median_of(std::vector<double> values);

/// Summary of a list of deviations. Lengths are metres; none if no deviation is known.
struct DeviationStatistics {
  std::size_t points = 0;   //!< in all
  std::size_t unknown = 0;  //!< of these, without a known deviation
  std::optional<double> rms, median, min, max;
  std::optional<double> within_tolerance;  //!< share of the known ones
};

/// @param deviations [m], NaN where not known
/// @param tolerance [m] half width
DeviationStatistics statistics_of(const std::vector<double>& deviations, double tolerance);

}  // namespace part_recipes
