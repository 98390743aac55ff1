// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "peaks/fir_derivative.h"
#include "peaks/stripe.h"

namespace tecnogamma_camera {

/// Edges of a spot in a row [px], interpolated between columns.
struct Edges {
  double rise = 0;
  double fall = 0;

  double width() const { return fall - rise; }
  double middle() const { return 0.5 * (rise + fall); }
};

/// Edges at a trigger level that was given.
template <class Pixel>
Edges edges_at(const Pixel* row, const Spot& spot, int level) {
  return {crossing(row, spot.rise, spot.rise - 1, level),
          crossing(row, spot.fall - 1, spot.fall, level)};
}

/// Edges at half of the stripe's height above the background.
template <class Pixel>
Edges edges_at_half(const Pixel* row, const Stripe& stripe) {
  const double climb = 0.5 * stripe.slope * (stripe.fall - stripe.rise);
  return {crossing(row, stripe.rise, stripe.rise - 1, stripe.half() - climb),
          crossing(row, stripe.fall - 1, stripe.fall, stripe.half() + climb)};
}

// Locators: each finds the column of the peak in a row. With a given trigger level, those that do
// not need the stripe get none.

/// The middle between the edges.
struct ThresholdLocator {
  static constexpr bool kNeedsStripe = false;

  template <class Pixel>
  double operator()(const Pixel*, int, const Stripe&, const Edges& edges) const {
    return edges.middle();
  }
};

/// The centre of gravity of the grey values above the stripe's foot, by the rule of make_detector.
struct CenterOfGravityLocator {
  static constexpr bool kNeedsStripe = true;
  // Share of the width; chosen: a Gaussian's foot is 0.33 beyond the edge.
  static constexpr double kMarginShare = 0.4;
  int window;

  template <class Pixel>
  double operator()(const Pixel* row, int, const Stripe& stripe, const Edges&) const {
    const int width = stripe.fall - stripe.rise;
    int margin = std::max(1, static_cast<int>(std::ceil(kMarginShare * width)));
    if (window > 0) margin = std::clamp((window - width) / 2, 0, margin);
    const int first = std::max(stripe.foot_rise, stripe.rise - margin);
    const int end = std::min(stripe.foot_fall, stripe.fall + margin);
    // In whole numbers, about the middle of the columns: offsets are in half columns.
    std::int64_t sum = 0;
    std::int64_t moment = 0;
    for (int column = first; column < end; ++column) {
      sum += row[column];
      moment += static_cast<std::int64_t>(row[column]) * (2 * column - (first + end - 1));
    }
    const double columns = end - first;
    const double squares = columns * (columns * columns - 1) / 12;  // of the offsets [px^2]
    const double middle = 0.5 * (first + end - 1);
    const double ground = stripe.foot() + stripe.slope * (middle - stripe.middle());
    const double light = static_cast<double>(sum) - ground * columns;
    const double column =
        middle + (0.5 * static_cast<double>(moment) - stripe.slope * squares) / light;
    return column > stripe.rise - 1 && column < stripe.fall ? column : kNoPeak;
  }
};

/// The zero of the row's smoothed derivative, by the rule of make_detector.
struct FirDerivativeLocator {
  static constexpr bool kNeedsStripe = true;

  template <class Pixel>
  double operator()(const Pixel* row, int columns, const Stripe& stripe, const Edges&) const {
    const double width = edges_at_half(row, stripe).width();
    return zero_crossing(row, columns, {stripe.rise, stripe.fall, width, stripe.slope});
  }
};

}  // namespace tecnogamma_camera
