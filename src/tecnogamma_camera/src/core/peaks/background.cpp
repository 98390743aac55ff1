// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "peaks/background.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "peaks/vector_clones.h"

namespace tecnogamma_camera {
namespace {

constexpr int kSampledRows = 4;  // of a band; chosen

// The 25 % and 5 % quantiles of a normal distribution are 0.6745 and 1.6449 standard deviations
// below its median.
constexpr double kUpper = 0.25;                       // of the pixels; chosen
constexpr double kLower = 0.05;                       // of the pixels; chosen
constexpr double kUpperBelowMedian = 0.6745;          // standard deviations
constexpr double kUpperAboveLower = 1.6449 - 0.6745;  // standard deviations
constexpr double kMaxBlack = 0.75;  // of the pixels; above it, noise <= 1 grey value; chosen

/// Pixels of a tile, one after another.
template <class Pixel>
struct Sample {
  Pixel pixels[kSampledRows * 3 / 2 * Background<Pixel>::kTileColumns];  // of the widest tile
  int size = 0;
};

template <class Pixel>
TECNOGAMMA_INLINE int count_at_most(const Sample<Pixel>& sample, Pixel level) {
  // In bytes side by side, for vector instructions; none of them overflows.
  constexpr int kLanes = 64;  // bytes; chosen
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
/// found by counting from `guess`: the next tile is usually only a few grey values off.
template <class Pixel>
TECNOGAMMA_INLINE double quantile(const Sample<Pixel>& sample, double share, int guess) {
  const double wanted = share * sample.size;
  int low = 0;                                   // too few pixels are below it ...
  int below = 0;                                 // ... these
  int high = std::numeric_limits<Pixel>::max();  // enough are at most it ...
  int at_most = sample.size;                     // ... these
  int level = guess;
  for (int step = 1; low < high; step = std::min(2 * step, high)) {
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

/// Subtracts an offset and a slope about the middle from a row.
template <class Pixel>
void take_out(double slope, double offset, int columns, Pixel* pixels) {
  constexpr long kMost = std::numeric_limits<Pixel>::max();
  const double middle = 0.5 * (columns - 1);
  for (int i = 0; i < columns; ++i)
    pixels[i] = static_cast<Pixel>(
        std::clamp(std::lround(pixels[i] - offset - slope * (i - middle)), 0L, kMost));
}

/// Noise and background where black clips the noise, so that its low quantiles say nothing. The
/// differences of neighbours do: four fifths of them are below 1.81 standard deviations of
/// unclipped noise, and below fewer the more of it is clipped (a parabola fitted to simulated
/// values). A line has large differences only at its flanks.
/// @param black share of the pixels at zero
template <class Pixel>
TECNOGAMMA_INLINE TileLight light_of_clipped(const Sample<Pixel>& sample, double black) {
  TileLight light;
  if (black > kMaxBlack) return light;
  Sample<Pixel> differences;
  differences.size = sample.size - 1;
  for (int i = 0; i < differences.size; ++i)
    differences.pixels[i] =
        static_cast<Pixel>(std::abs(int{sample.pixels[i + 1]} - int{sample.pixels[i]}));
  constexpr double kShare = 0.8;  // of the differences; chosen
  const double deviations = 1.807 - 1.223 * black - 0.633 * black * black;  // the fitted parabola
  light.noise = std::max(0.0, quantile(differences, kShare, 1)) / deviations;
  light.background = std::max(0.0, quantile(sample, 0.5, 1));
  return light;
}

/// @param guess background and noise of another tile
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
    : image_(image),
      tiles_(std::max(1, (image.columns + kTileColumns / 2) / kTileColumns)),
      bands_((image.rows + kBandRows - 1) / kBandRows) {
  measured_.resize(static_cast<std::size_t>(bands_) * static_cast<std::size_t>(tiles_));
  for (int tile = 0; tile < tiles_; ++tile)
    middles_.push_back(0.5 * (first_column_of(tile) + first_column_of(tile + 1) - 1));
}

template <class Pixel>
const TileLight& Background<Pixel>::tile(int row, int tile) {
  const int band = row / kBandRows;
  std::optional<TileLight>& light = at(band, tile).light;
  if (!light) light = without_climb(band, tile);
  return *light;
}

template <class Pixel>
const TileLight& Background<Pixel>::as_level(int band, int tile) {
  std::optional<TileLight>& level = at(band, tile).level;
  if (!level) level = last_ = measure(band, tile, 0, 0, last_);
  return *level;
}

template <class Pixel>
TileLight Background<Pixel>::without_climb(int band, int tile) {
  const TileLight level = as_level(band, tile);
  // A smaller slope may come from the noise of the tiles.
  const double least = (1 + level.noise) / kTileColumns;
  const auto if_any = [&](double slope) { return std::abs(slope) < least ? 0 : slope; };
  const double across = if_any(slope_across(band, tile));
  const double down = if_any(slope_down(band, tile));
  if (across == 0 && down == 0) return level;
  TileLight light = measure(band, tile, across, down, level);
  light.down = down;
  return light;
}

template <class Pixel>
double Background<Pixel>::slope_across(int band, int tile) {
  const int left = std::max(0, tile - 1);
  const int right = std::min(tiles_ - 1, tile + 1);
  if (left == right) return 0;
  return (as_level(band, right).background - as_level(band, left).background) /
         (middles_[right] - middles_[left]);
}

template <class Pixel>
double Background<Pixel>::slope_down(int band, int tile) {
  const int upper = std::max(0, band - 1);
  const int lower = std::min(bands_ - 1, band + 1);
  if (upper == lower) return 0;
  return (as_level(lower, tile).background - as_level(upper, tile).background) /
         (middle_row_of(lower) - middle_row_of(upper));
}

template <class Pixel>
TileLight Background<Pixel>::measure(int band, int tile, double across, double down,
                                     const TileLight& guess) const {
  const int first_row = band * kBandRows;
  const int rows = std::min(kBandRows, image_.rows - first_row);
  const int first_column = first_column_of(tile);
  const int columns = first_column_of(tile + 1) - first_column;
  Sample<Pixel> sample;
  for (int i = 0; i < kSampledRows; ++i) {
    const int row = first_row + rows * (2 * i + 1) / (2 * kSampledRows);
    Pixel* const pixels = sample.pixels + sample.size;
    std::copy_n(image_.row(row) + first_column, columns, pixels);
    if (across != 0 || down != 0)
      take_out(across, down * (row - middle_row_of(band)), columns, pixels);
    sample.size += columns;
  }
  return measure_sample(sample, guess);
}

template <class Pixel>
BackgroundLine Background<Pixel>::about(int row, int column) {
  const int here = tile_of(column);
  const TileLight& light = tile(row, here);
  const double at_row = light.background + light.down * (row - middle_row_of(row / kBandRows));
  if (tiles_ == 1) return {at_row, 0};
  const double from_middle = column - middles_[here];
  const bool to_the_left = here > 0 && (from_middle < 0 || here == tiles_ - 1);
  const int other = to_the_left ? here - 1 : here + 1;
  const double across =
      (tile(row, other).background - light.background) / (middles_[other] - middles_[here]);
  return {at_row + across * from_middle, across};
}

template class Background<std::uint8_t>;
template class Background<std::uint16_t>;

}  // namespace tecnogamma_camera
