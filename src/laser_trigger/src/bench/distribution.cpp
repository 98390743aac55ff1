// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "distribution.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace laser_trigger {
namespace {

std::string bar(double share) {
  constexpr double kWidth = 30;  // characters; chosen
  return std::string(static_cast<std::size_t>(std::ceil(share * kWidth)), '#');
}

}  // namespace

double Distribution::quantile(double share) const {
  std::vector<double> sorted = values_;
  std::sort(sorted.begin(), sorted.end());
  const double rank = std::ceil(share * static_cast<double>(sorted.size())) - 1;
  return sorted.at(static_cast<std::size_t>(std::max(0.0, rank)));
}

double Distribution::share_above(double microseconds) const {
  const auto above = std::count_if(values_.begin(), values_.end(),
                                   [=](double value) { return value > microseconds; });
  return static_cast<double>(above) / static_cast<double>(values_.size());
}

void print_quantiles(const std::string& name, const Distribution& values) {
  std::printf("  %-34s p50 %8.1f   p99 %8.1f   p99.9 %8.1f   max %8.1f us\n", name.c_str(),
              values.quantile(0.5), values.quantile(0.99), values.quantile(0.999),
              values.quantile(1));
}

void print_histogram(const std::string& name, const Distribution& values,
                     const std::string& yardstick_name, const Distribution& yardstick) {
  std::printf("  %15s  %-38s %s\n", "late [us]", name.c_str(), yardstick_name.c_str());
  constexpr double kFirst = 4, kLast = 8192;  // [us] chosen
  for (double low = 0, high = kFirst; low < kLast; low = high, high *= 2) {
    const double top = high >= kLast ? INFINITY : high;
    const double mine = values.share_above(low) - values.share_above(top);
    const double other = yardstick.share_above(low) - yardstick.share_above(top);
    const double below = low == 0 ? 1 : 0;  // values up to zero are in the first class
    const double share = mine + below * (1 - values.share_above(0));
    const double other_share = other + below * (1 - yardstick.share_above(0));
    if (share == 0 && other_share == 0) continue;
    std::printf("  %6.0f .. %5.0f  %6.2f %% %-30s %6.2f %% %s\n", low, top, 100 * share,
                bar(share).c_str(), 100 * other_share, bar(other_share).c_str());
  }
}

}  // namespace laser_trigger
