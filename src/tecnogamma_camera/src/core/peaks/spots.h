// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "peaks/lit_pixels.h"
#include "peaks/trigger_levels.h"
#include "tecnogamma_camera/peak_detector.h"

namespace tecnogamma_camera {

/// A lit run in one row, and the free space around it.
struct Spot {
  int rise = 0;      //!< first lit column
  int fall = 0;      //!< first dark column after it; 0: no spot
  int left = 0;      //!< half way to the spot before it, or the first column
  int right = 0;     //!< half way to the spot after it, or one past the last column
  bool cut = false;  //!< by the image's border
};

/// Most rows have one spot: its light is summed only if there is another to compare it with.
constexpr std::int64_t kNotSummed = std::numeric_limits<std::int64_t>::min();

/// First dark column of the spot whose rising edge is at `rise`. Dips shorter than the permanence
/// belong to the spot.
inline int falling_edge(const LitPixels& lit, int rise, int columns, int permanence) {
  for (;;) {
    const int end = lit.next_dark(rise);
    rise = lit.next_lit(end);
    if (rise - end >= permanence || rise == columns) return end;
  }
}

/// The spots of a row from left to right, by the rule of PeakDetector.
/// @param take called with each spot; its `right` is not known yet
/// @param pass_over called with the column of each lone lit pixel that is not a spot
template <class Take, class PassOver>
void for_each_spot(const LitPixels& lit, int columns, int permanence, const Take& take,
                   const PassOver& pass_over) {
  int last_fall = -1;
  for (int column = lit.next_lit(0); column < columns;) {
    const int run_end = lit.next_dark(column);
    if (run_end - column < permanence) {
      if (run_end - column == 1) pass_over(column);
      column = lit.next_lit(run_end);
      continue;
    }
    Spot spot;
    spot.rise = column;
    spot.fall = falling_edge(lit, column, columns, permanence);
    spot.left = last_fall < 0 ? 0 : (last_fall + spot.rise + 1) / 2;
    spot.right = columns;
    spot.cut = spot.rise == 0 || spot.fall + permanence > columns;
    take(spot);
    last_fall = spot.fall;
    column = lit.next_lit(spot.fall);
  }
}

/// Sum of a spot's grey values above the trigger level.
template <class Pixel>
std::int64_t light_above(const Pixel* row, const Spot& spot, const TriggerLevels<Pixel>& levels) {
  std::int64_t sum = 0;
  for (int i = spot.rise; i < spot.fall; ++i)
    sum += row[i] - levels.at(i);
  return sum;
}

/// The row's spot by the rule of Choice; its fall is 0 if there is none.
/// @param fits tells whether a spot may be the laser's
/// @param hot lone hot pixels of the row
template <class Pixel, class Fits>
Spot choose_spot(const Pixel* row, int columns, const LitPixels& lit,
                 const TriggerLevels<Pixel>& levels, const DetectorSettings& settings,
                 const Fits& fits, std::vector<int>& hot) {
  Spot best;
  std::int64_t most = kNotSummed;
  bool best_is_last = false;
  hot.clear();
  const auto take = [&](const Spot& spot) {
    const int width = spot.fall - spot.rise;
    if (levels.may_be_noise(width) &&
        !levels.is_enough(light_above(row, spot, levels), spot.rise, width))
      return;
    if (best_is_last) best.right = (best.fall + spot.rise) / 2;
    best_is_last = false;
    if (!fits(spot)) return;
    best_is_last = best.fall == 0 || settings.choice == Choice::kLast;
    if (best.fall > 0 && settings.choice == Choice::kBrightest) {
      if (most == kNotSummed) most = light_above(row, best, levels);
      const std::int64_t light = light_above(row, spot, levels);
      best_is_last = light > most;
      most = std::max(most, light);
    }
    if (best_is_last) best = spot;
  };
  for_each_spot(lit, columns, settings.permanence, take, [&](int column) {
    if (levels.is_hot(row[column], column)) hot.push_back(column);
  });
  return best;
}

}  // namespace tecnogamma_camera
