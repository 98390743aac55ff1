// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace laser_trigger {

/// Durations of one kind [us], as they came.
class Distribution {
 public:
  void add(double microseconds) { values_.push_back(microseconds); }
  bool empty() const { return values_.empty(); }
  std::size_t size() const { return values_.size(); }

  /// @param share of the values that are not above the result, 0 .. 1; 1: the greatest
  double quantile(double share) const;
  double share_above(double microseconds) const;

 private:
  std::vector<double> values_;
};

/// One line: p50, p99, p99.9 and the greatest.
void print_quantiles(const std::string& name, const Distribution& values);

/// Two side by side: the share of each in every octave.
void print_histogram(const std::string& name, const Distribution& values,
                     const std::string& yardstick_name, const Distribution& yardstick);

}  // namespace laser_trigger
