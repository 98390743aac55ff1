// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace laser_trigger {

/// Durations of one kind [us], in order of arrival.
class Distribution {
 public:
  void add(double microseconds) { values_.push_back(microseconds); }
  bool empty() const { return values_.empty(); }
  std::size_t size() const { return values_.size(); }

  /// @param share of values that do not exceed the result, 0 .. 1; 1: the maximum
  double quantile(double share) const;
  double share_above(double microseconds) const;

 private:
  std::vector<double> values_;
};

/// Prints one line: p50, p99, p99.9 and the maximum.
void print_quantiles(const std::string& name, const Distribution& values);

/// Prints two side by side: the share of each in every octave.
void print_histogram(const std::string& name, const Distribution& values,
                     const std::string& yardstick_name, const Distribution& yardstick);

}  // namespace laser_trigger
