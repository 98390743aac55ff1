// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace scan_calibration {

/// NaN of none.
double median(std::vector<double> values);

/// Values that stand out above the others: their logarithm is further from the median's than
/// `deviations` times what the others scatter by, and they are at least `factor` times the median.
std::vector<bool> outstanding(const std::vector<double>& values, double deviations, double factor);

/// Three significant digits and a unit.
std::string figure(double value, const char* unit);

/// "9 of 20"
std::string share(std::size_t part, std::size_t whole);

}  // namespace scan_calibration
