// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace part_recipes {

/// Control limits of single values and of their moving ranges, in the unit of the values.
struct IndividualsChart {
  std::size_t count = 0;                 //!< of values
  double mean = 0;                       //!< of the values
  double sigma = 0;                      //!< from one value to the next: mean moving range / d2
  double lower = 0, upper = 0;           //!< mean -+ 3 sigma
  double moving_range_mean = 0;          //!< of neighbours
  double moving_range_upper = 0;         //!< its upper control limit; the lower one is 0
  std::vector<double> moving_ranges;     //!< count - 1 of them: |value i+1 - value i|
  std::vector<std::size_t> wide_ranges;  //!< indices of values whose range to the one before is
                                         //!< beyond the upper limit
};

/// The chart of individuals and moving ranges (X-mR, I-MR): NIST/SEMATECH e-Handbook of Statistical
/// Methods, 6.3.2.2; Montgomery, Introduction to Statistical Quality Control, "control charts for
/// individual measurements".
/// @param values in the order in which they arose, all of them finite
/// @return none for fewer than two values
std::optional<IndividualsChart> individuals_chart(const std::vector<double>& values);

}  // namespace part_recipes
