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

/// What a list of deviations comes to. Lengths are metres; none where no deviation is known.
struct DeviationStatistics {
  std::size_t points = 0;   //!< in all
  std::size_t unknown = 0;  //!< of which no deviation is known
  std::optional<double> rms, median, min, max;
  std::optional<double> within_tolerance;  //!< share of the known ones
};

/// @param deviations [m], NaN where not known
/// @param tolerance [m] half width
DeviationStatistics statistics_of(const std::vector<double>& deviations, double tolerance);

}  // namespace part_recipes
