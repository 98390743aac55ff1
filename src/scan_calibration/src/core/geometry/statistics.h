// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scan_cell_common/pose/units.h"

namespace scan_calibration {

using scan_cell_common::kDegree;
constexpr double kDeviationPerMedian =
    1.4826;                                 // normal noise: deviation over median absolute value
constexpr double kMedianLength2 = 1.17741;  // of two numbers of unit noise: sqrt(2 ln 2)
constexpr double kMedianLength3 = 1.5382;   // of three: root of the median of chi-square, 3 d.o.f.

/// NaN for an empty list.
double median(std::vector<double> values);

/// The same for a list that is not empty; of two middle values the larger.
inline double upper_median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// At most `max_count` of `count` indices, spread evenly: the middle of each of equal stretches.
inline std::vector<std::size_t> evenly(std::size_t count, std::size_t max_count) {
  const std::size_t kept = std::min(count, max_count);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < kept; ++i)
    result.push_back((2 * i + 1) * count / (2 * kept));
  return result;
}

/// Sum of squares, and their number.
struct SquareSum {
  double squares = 0;
  double count = 0;

  void add(double square) {
    squares += square;
    count += 1;
  }
  void add(const SquareSum& other) {
    squares += other.squares;
    count += other.count;
  }
  double rms() const { return std::sqrt(squares / count); }
};

/// Marks outliers: values that are at least `factor` times the median and whose logarithm is more
/// than `deviations` robust standard deviations of the logarithms above the median.
std::vector<bool> outstanding(const std::vector<double>& values, double deviations, double factor);

/// Three significant digits and a unit: "0.123 px".
std::string figure(double value, const char* unit);

/// @param length [m]; the text is in mm
std::string millimetres(double length);

/// @param angle [rad]; the text is in deg
std::string degrees(double angle);

/// "9 of 20"
std::string share(std::size_t part, std::size_t whole);

}  // namespace scan_calibration
