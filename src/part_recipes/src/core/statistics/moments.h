// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace part_recipes {

/// Mean; exact if all values are equal.
/// @param values one or more
double mean_of(const std::vector<double>& values);

/// Standard deviation of the sample, with count - 1.
/// @param values two or more
double standard_deviation_of(const std::vector<double>& values);

}  // namespace part_recipes
