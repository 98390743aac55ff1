// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "background.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "vector_clones.h"

namespace tecnogamma_camera {
namespace {

constexpr int kSampledRows = 4;  // of a band

// Quartile and twentieth of a normal distribution are 0.6745 and 1.6449 standard deviations below
// its middle.
constexpr double kUpper = 0.25;
constexpr double kLower = 0.05;
constexpr double kUpperBelowMedian = 0.6745;
constexpr double kUpperAboveLower = 1.6449 - 0.6745;
constexpr double kMostBlack = 0.75;  // with less left of it, noise of one grey value or less

/// Pixels of a tile, one after another.
template <class Pixel>
struct Sample {
  Pixel pixels[kSampledRows * kTileColumns];
  int size = 0;
};

template <class Pixel>
TECNOGAMMA_INLINE int count_at_most(const Sample<Pixel>& sample, Pixel level) {
  // Side by side in bytes, which fill a vector; none of them counts further than a byte can.
  constexpr int kLanes = 64;
  std::uint8_t counts[kLanes] = {};
  int first = 0;
  for (; first + kLanes <= sample.size; first += kLanes)
    for (int i = 0; i < kLanes; ++i)
      counts[i] = static_cast<std::uint8_t>(counts[i] + (sample.pixels[first + i] <= level));
  int count = 0;
  for (const std::uint8_t lane : counts)
    count += lane;
  for (; first < sample.size; ++first)
    count += sample.pixels[first] <= level;
  return count;
}

/// Quantile of the sample, as if the grey values were spread evenly over their rounding. It is
/// sought by counting, from `guess` on: the next tile's is mostly a few grey values off.
template <class Pixel>
TECNOGAMMA_INLINE double quantile(const Sample<Pixel>& sample, double share, int guess) {
  const double wanted = share * sample.size;
  int low = 0;                                   // too few pixels are below it ...
  int below = 0;                                 // ... these
  int high = std::numeric_limits<Pixel>::max();  // enough are at most it ...
  int at_most = sample.size;                     // ... these
  int level = guess;
  for (int step = 1; low < high; step *= 2) {
    const int count = count_at_most(sample, static_cast<Pixel>(level));
    const bool is_enough = count >= wanted;
    if (is_enough) {
      high = level;
      at_most = count;
    } else {
      low = level + 1;
      below = count;
    }
    const bool is_enclosed = low > 0 && high < std::numeric_limits<Pixel>::max();
    level = is_enclosed ? (low + high) / 2 : is_enough ? high - step : low + step - 1;
    level = std::clamp(level, low, std::max(low, high - 1));
  }
  return low - 0.5 + (wanted - below) / std::max(1, at_most - below);
}

/// @param guess background and noise of another tile
/// Where the camera's black cut the noise off, its low quantiles say nothing. The differences of
/// neighbours do: four fifths of them are below 1.81 standard deviations of whole noise, and below
/// less of them the more of it was cut off (a parabola through simulated values). A line has large
/// ones only at its flanks.
/// @param black share of the pixels at zero
template <class Pixel>
TECNOGAMMA_INLINE TileLight light_of_clipped(const Sample<Pixel>& sample, double black) {
  TileLight light;
  light.measured = true;
  if (black > kMostBlack) return light;
  Sample<Pixel> differences;
  differences.size = sample.size - 1;
  for (int i = 0; i < differences.size; ++i)
    differences.pixels[i] =
        static_cast<Pixel>(std::abs(int{sample.pixels[i + 1]} - int{sample.pixels[i]}));
  light.noise = std::max(0.0, quantile(differences, 0.8, 1)) /
                (1.807 - 1.223 * black - 0.633 * black * black);
  light.background = std::max(0.0, quantile(sample, 0.5, 1));
  return light;
}

template <class Pixel>
TECNOGAMMA_INLINE TileLight light_of(const Sample<Pixel>& sample, const TileLight& guess) {
  const double black = count_at_most(sample, Pixel{0}) / static_cast<double>(sample.size);
  if (black > kLower) return light_of_clipped(sample, black);
  constexpr double kMost = std::numeric_limits<Pixel>::max();
  const auto start = [&](double deviations) {
    return static_cast<int>(
        std::lround(std::clamp(guess.background - deviations * guess.noise, 0.0, kMost)));
  };
  const double upper = quantile(sample, kUpper, start(kUpperBelowMedian));
  const double lower = quantile(sample, kLower, start(kUpperBelowMedian + kUpperAboveLower));
  TileLight light;
  light.noise = std::max(0.0, upper - lower) / kUpperAboveLower;
  light.background = upper + kUpperBelowMedian * light.noise;
  light.measured = true;
  return light;
}

TECNOGAMMA_VECTOR_CLONES TileLight measure_sample(const Sample<std::uint8_t>& sample,
                                                  const TileLight& guess) {
  return light_of(sample, guess);
}

TECNOGAMMA_VECTOR_CLONES TileLight measure_sample(const Sample<std::uint16_t>& sample,
                                                  const TileLight& guess) {
  return light_of(sample, guess);
}

}  // namespace

template <class Pixel>
Background<Pixel>::Background(const ImageView<Pixel>& image)
    : image_(image), tiles_(tiles_in(image.columns)) {
  const int bands = (image.rows + kBandRows - 1) / kBandRows;
  light_.resize(static_cast<std::size_t>(bands) * static_cast<std::size_t>(tiles_));
}

template <class Pixel>
const TileLight& Background<Pixel>::tile(int row, int tile) {
  const int band = row / kBandRows;
  const auto index = static_cast<std::size_t>(band) * static_cast<std::size_t>(tiles_) +
                     static_cast<std::size_t>(tile);
  if (!light_[index].measured)
    light_[index] = measure(band, tile, light_[index > 0 ? index - 1 : 0]);
  return light_[index];
}

template <class Pixel>
TileLight Background<Pixel>::measure(int band, int tile, const TileLight& guess) const {
  const int first_row = band * kBandRows;
  const int rows = std::min(kBandRows, image_.rows - first_row);
  const int first_column = first_column_of(tile);
  const int columns = std::min(kTileColumns, image_.columns - first_column);
  Sample<Pixel> sample;
  for (int i = 0; i < kSampledRows; ++i) {
    const int row = first_row + rows * (2 * i + 1) / (2 * kSampledRows);
    std::copy_n(image_.row(row) + first_column, columns, sample.pixels + sample.size);
    sample.size += columns;
  }
  return measure_sample(sample, guess);
}

template <class Pixel>
int Background<Pixel>::first_column_of(int tile) const {
  return std::max(0, std::min(tile * kTileColumns, image_.columns - kTileColumns));
}

template <class Pixel>
BackgroundLine Background<Pixel>::about(int row, int column) {
  const int here = column / kTileColumns;
  const int half = std::min(kTileColumns, image_.columns) / 2;
  const int middle = first_column_of(here) + half;
  const int next = std::clamp(here + (column < middle ? -1 : 1), 0, tiles_ - 1);
  const int distance = first_column_of(next) - first_column_of(here);
  const double background = tile(row, here).background;
  if (std::abs(distance) < half) return {background, 0};
  const double slope = (tile(row, next).background - background) / distance;
  return {background + slope * (column - middle + 0.5), slope};
}

template class Background<std::uint8_t>;
template class Background<std::uint16_t>;

}  // namespace tecnogamma_camera
