// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "tecnogamma_camera/peak_detector.h"

namespace tecnogamma_camera {

/// A run of light in one row, and the free space about it.
struct Spot {
  int rise = 0;   //!< first lit column
  int fall = 0;   //!< first dark column after it
  int left = 0;   //!< half way to the spot before it, or the first column
  int right = 0;  //!< half way to the spot after it, or one past the last column
  bool cut = false;
  std::int64_t sum = 0;  //!< of the grey values from rise to fall; 0: no spot

  int width() const { return fall - rise; }
  double middle() const { return 0.5 * (rise + fall - 1); }
};

/// First column in [from, to) above `level`, or `to`. Dark pixels, nearly all of a frame, are
/// passed over in blocks, whose maximum the compiler turns into vector instructions.
template <class Pixel>
int next_lit(const Pixel* row, int from, int to, Pixel level) {
  constexpr int kBlock = 64;
  while (from + kBlock <= to) {
    Pixel most = 0;
    for (int i = 0; i < kBlock; ++i)
      most = std::max(most, row[from + i]);
    if (most > level) break;
    from += kBlock;
  }
  while (from < to && row[from] <= level)
    ++from;
  return from;
}

/// First column in [from, to) not above `level`, or `to`.
template <class Pixel>
int next_dark(const Pixel* row, int from, int to, Pixel level) {
  while (from < to && row[from] > level)
    ++from;
  return from;
}

/// End of the spot whose first lit run ends at `end`: dips shorter than the permanence belong to
/// it.
template <class Pixel>
int falling_edge(const Pixel* row, int end, int columns, Pixel level, int permanence) {
  for (;;) {
    const int limit = std::min(columns, end + permanence);
    int lit = end;
    while (lit < limit && row[lit] <= level)
      ++lit;
    if (lit == limit) return end;
    end = next_dark(row, lit, columns, level);
  }
}

/// The row's spot by the rule of PeakDetector; its sum is 0 if there is none.
template <class Pixel>
Spot brightest_spot(const Pixel* row, int columns, const DetectorSettings& settings) {
  const Pixel level = static_cast<Pixel>(settings.trigger_level);
  Spot best;
  int last_fall = -1;
  bool best_is_last = false;
  int column = next_lit(row, 0, columns, level);
  while (column < columns) {
    const int run_end = next_dark(row, column, columns, level);
    if (run_end - column < settings.permanence) {
      column = next_lit(row, run_end, columns, level);
      continue;
    }
    Spot spot;
    spot.rise = column;
    spot.fall = falling_edge(row, run_end, columns, level, settings.permanence);
    spot.left = last_fall < 0 ? 0 : (last_fall + spot.rise + 1) / 2;
    spot.right = columns;
    spot.cut = spot.rise == 0 || spot.fall + settings.permanence > columns;
    for (int i = spot.rise; i < spot.fall; ++i)
      spot.sum += row[i];
    if (best_is_last) best.right = (best.fall + spot.rise) / 2;
    best_is_last = spot.sum > best.sum;
    if (best_is_last) best = spot;
    last_fall = spot.fall;
    column = next_lit(row, spot.fall, columns, level);
  }
  return best;
}

/// Fills a profile; `locate(row, spot)` gives the column of the peak within the image.
template <class Pixel, class Locate>
void detect_rows(const ImageView<Pixel>& image, const DetectorSettings& settings,
                 const Locate& locate, PeakProfile& profile) {
  profile.clear(image.first_row, image.rows);
  for (int index = 0; index < image.rows; ++index) {
    const Pixel* row = image.row(index);
    const Spot spot = brightest_spot(row, image.columns, settings);
    if (spot.sum == 0 || spot.cut) continue;
    profile.position[index] = static_cast<float>(image.first_column + locate(row, spot));
    profile.width[index] = static_cast<float>(spot.width());
    profile.intensity[index] =
        static_cast<float>(*std::max_element(row + spot.rise, row + spot.fall));
  }
}

/// Columns of window on each side of a spot that is not cut: it has a dark pixel either side.
inline int window_margin(const Spot& spot, int window) {
  const int wanted = (window - spot.width()) / 2;
  return std::max(1, std::min({wanted, spot.rise - spot.left, spot.right - spot.fall}));
}

/// Centre of gravity over the window of a spot that is not cut, by the rule of
/// CenterOfGravityDetector. The window is symmetric about the middle, so an error of the background
/// only scales the small distance from it.
template <class Pixel>
double center_of_gravity(const Pixel* row, const Spot& spot, int window) {
  const int margin = window_margin(spot, window);
  const int first = spot.rise - margin;
  const int last = spot.fall + margin - 1;
  const int border = std::min(margin, 2);
  std::int64_t border_sum = 0;
  for (int i = 0; i < border; ++i)
    border_sum += row[first + i] + row[last - i];
  const double background = static_cast<double>(border_sum) / (2 * border);

  std::int64_t sum = 0;
  std::int64_t moment = 0;
  for (int column = first; column <= last; ++column) {
    sum += row[column];
    moment += static_cast<std::int64_t>(row[column]) * (2 * column - (first + last));
  }
  const double light = static_cast<double>(sum) - background * (last - first + 1);
  const double offset = light > 0 ? 0.5 * static_cast<double>(moment) / light : 0;
  const double reach = 0.5 * spot.width();
  return spot.middle() + std::clamp(offset, -reach, reach);
}

}  // namespace tecnogamma_camera
