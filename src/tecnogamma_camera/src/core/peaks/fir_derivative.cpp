// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "peaks/fir_derivative.h"

namespace tecnogamma_camera {
namespace {

constexpr double kNarrowest = 1.0;  // [px] sigma; chosen
constexpr double kRatio = 1.3;      // from one filter to the next: they fit to 14 %; chosen
constexpr int kFilters = 13;        // to a sigma of 23 px; chosen
constexpr double kReach = 2.75;     // sigmas; chosen

std::vector<DerivativeFilter> make_filters() {
  std::vector<DerivativeFilter> filters;
  double sigma = kNarrowest;
  for (int i = 0; i < kFilters; ++i, sigma *= kRatio)
    filters.emplace_back(sigma);
  return filters;
}

}  // namespace

DerivativeFilter::DerivativeFilter(double gaussian_sigma) : sigma(gaussian_sigma) {
  const int reach = static_cast<int>(std::ceil(kReach * sigma));
  slope_response = 0;
  for (int i = 1; i <= reach; ++i) {
    taps.push_back(i * std::exp(-0.5 * i * i / (sigma * sigma)));
    slope_response += taps.back() * 2 * i;
  }
}

const DerivativeFilter& filter_for(double width) {
  static const std::vector<DerivativeFilter> filters = make_filters();
  const double wanted = std::max(sigma_of_width(width) / kNarrowest, 1.0);
  const int index = static_cast<int>(std::lround(std::log(wanted) / std::log(kRatio)));
  return filters[static_cast<std::size_t>(std::min(index, kFilters - 1))];
}

}  // namespace tecnogamma_camera
