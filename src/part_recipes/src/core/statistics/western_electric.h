// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace part_recipes {

/// A rule that values of a control chart break.
struct RuleBreak {
  int rule = 0;                     //!< 1 to 4
  std::size_t at = 0;               //!< index of the value with which it is broken
  std::vector<std::size_t> points;  //!< indices of the values that break it, the last one is `at`
};

/// The rules of the Western Electric handbook (Statistical Quality Control Handbook, 1956; NIST
/// e-Handbook 6.3.2), each applied on either side of the mean:
/// 1: a value beyond 3 sigma; 2: two of three successive values beyond 2 sigma; 3: four of five
/// beyond 1 sigma; 4: eight successive values on the same side.
/// @param values in their order
/// @param mean, sigma of the chart, in the values' unit
/// @return in the order of `at`, then of the rule
std::vector<RuleBreak> western_electric(const std::vector<double>& values, double mean,
                                        double sigma);

}  // namespace part_recipes
