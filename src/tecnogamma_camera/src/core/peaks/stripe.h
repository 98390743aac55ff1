// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "peaks/background.h"
#include "peaks/spots.h"

namespace tecnogamma_camera {

constexpr double kFootOfHalf = 0.3;  //!< of half of the height: the foot is at 15 %; chosen
// Half of a Gaussian's height, divided by the mean of its light weighted by itself: of the whole
// Gaussian, and of its part above half of the height.
constexpr double kHalfOfMean = 0.70711;      //!< sqrt(1 / 2)
constexpr double kHalfOfCoreMean = 0.59519;  //!< from the integrals
constexpr double kBridgedShare = 0.25;       //!< of the stripe's width: longest dip in it; chosen

/// The laser's light in a row, by the rule of PeakDetector.
struct Stripe {
  double background = 0;   //!< [grey value] at its middle
  double slope = 0;        //!< [grey values/px] of the background
  double half_height = 0;  //!< [grey value] above the background; 0: no stripe
  int rise = 0;            //!< first column above half of the height
  int fall = 0;            //!< one past the last
  int foot_rise = 0;       //!< first column above the foot
  int foot_fall = 0;       //!< one past the last
  int brightest = 0;       //!< [grey value]
  bool cut = false;        //!< the foot reaches the image's border

  double middle() const { return 0.5 * (rise + fall - 1); }
  double half() const { return background + half_height; }
  double foot() const { return background + kFootOfHalf * half_height; }
};

/// Where a falling or rising flank crosses a level, between a column inside and the next outside.
template <class Pixel>
double crossing(const Pixel* row, int inside, int outside, double level) {
  const double drop = static_cast<double>(row[inside]) - row[outside];
  const double share = drop > 0 ? std::clamp((row[inside] - level) / drop, 0.0, 1.0) : 0.5;
  return inside + share * (outside - inside);
}

/// Furthest column from `start` in steps of `step`, before `end`, that is above a level; dips of
/// fewer than `bridge` columns are bridged.
template <class Pixel>
int last_above(const Pixel* row, int start, int step, int end, int bridge, double level) {
  const int whole = static_cast<int>(level);
  int last = start;
  for (int column = start + step; column != end && std::abs(column - last) <= bridge;
       column += step)
    if (row[column] > whole) last = column;
  return last;
}

/// Moments of grey values, exact in whole numbers.
struct GreySums {
  std::int64_t pixels = 0;
  std::int64_t sum = 0;
  std::int64_t squares = 0;

  void add(std::int64_t grey) {
    sum += grey;
    squares += grey * grey;
  }

  /// Of the light above a background: [grey value x px], [grey value^2 x px].
  double light(double background) const {
    return static_cast<double>(sum) - background * static_cast<double>(pixels);
  }
  double light_of_squares(double background) const {
    return static_cast<double>(squares) -
           background * (2 * static_cast<double>(sum) - background * static_cast<double>(pixels));
  }
};

/// Height of a spot's stripe, and where to look for its edges.
struct Height {
  BackgroundLine background;  //!< about its middle
  double half = 0;            //!< [grey value] above the background; 0: no stripe
  int anchor = 0;             //!< brightest column
  int bridge = 0;             //!< [px] dips that are shorter belong to the stripe
};

template <class Pixel>
Height measure_height(const Pixel* row, const Spot& spot, const BackgroundLine& background,
                      int permanence) {
  Height height;
  height.background = background;
  height.anchor = spot.rise;
  GreySums all;
  all.pixels = spot.fall - spot.rise;
  Pixel brightest = 0;
  for (int column = spot.rise; column < spot.fall; ++column) {
    const Pixel grey = row[column];
    all.add(grey);
    height.anchor = grey > brightest ? column : height.anchor;
    brightest = std::max(brightest, grey);
  }
  const double light = all.light(background.value);
  const double squares = all.light_of_squares(background.value);
  const double mean = background.value + kHalfOfMean * squares / light;
  if (!(light > 0 && mean < brightest)) return height;  // more dark than lit
  const int floor = static_cast<int>(mean);
  GreySums core;
  for (int column = spot.rise; column < spot.fall; ++column) {
    const bool counts = row[column] > floor;
    core.pixels += counts;
    core.add(counts ? row[column] : 0);
  }
  height.half =
      kHalfOfCoreMean * core.light_of_squares(background.value) / core.light(background.value);
  height.bridge = std::max(permanence, static_cast<int>(kBridgedShare * light * light / squares));
  return height;
}

/// Whether the brightest pixel of a spot is a hot one beside the line, by the rule of PeakDetector.
template <class Pixel>
bool is_hot(const Pixel* row, int columns, const Spot& spot, const Height& height) {
  constexpr double kStandsOut = 4;  // times; chosen: a stripe of sigma 0.5 px reaches 4.4 at most
  constexpr double kOneSide = 3;    // times the light of the other side; chosen
  const int at = height.anchor;
  if (height.half == 0 || at == 0 || at == columns - 1) return false;
  const double background = height.background.value;
  const double light = row[at] - background;
  if (light <= kStandsOut * (std::max(row[at - 1], row[at + 1]) - background)) return false;
  double left = 0, right = 0;
  for (int column = spot.rise; column < at; ++column)
    left += row[column] - background;
  for (int column = at + 1; column < spot.fall; ++column)
    right += row[column] - background;
  const double more = std::max(left, right);
  return kStandsOut * more > light && more > kOneSide * std::min(left, right);
}

template <class Pixel>
Stripe find_stripe(const Pixel* row, int columns, const Spot& spot, const Height& height) {
  Stripe stripe;
  stripe.background = height.background.value;
  stripe.slope = height.background.slope;
  stripe.half_height = height.half;
  if (height.half == 0) return stripe;
  stripe.brightest = row[height.anchor];
  const int bridge = height.bridge;
  stripe.rise = last_above(row, height.anchor, -1, -1, bridge, stripe.half());
  stripe.fall = last_above(row, height.anchor, 1, columns, bridge, stripe.half()) + 1;
  const int left = std::min(spot.left, stripe.rise);
  const int right = std::max(spot.right, stripe.fall);
  stripe.foot_rise = last_above(row, stripe.rise, -1, left - 1, bridge, stripe.foot());
  stripe.foot_fall = last_above(row, stripe.fall - 1, 1, right, bridge, stripe.foot()) + 1;
  stripe.cut = stripe.foot_rise == 0 || stripe.foot_fall == columns;
  return stripe;
}

}  // namespace tecnogamma_camera
