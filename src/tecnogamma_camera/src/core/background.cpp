// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "background.h"

#include <algorithm>
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

/// Quantile of the sample at most `most`, as if the grey values were spread evenly over their
/// rounding: by bisection, which needs only counts.
template <class Pixel>
TECNOGAMMA_INLINE double quantile(const Sample<Pixel>& sample, double share, Pixel most) {
  const double wanted = share * sample.size;
  int low = 0;
  int high = most;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (count_at_most(sample, static_cast<Pixel>(middle)) >= wanted) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  const int below = low == 0 ? 0 : count_at_most(sample, static_cast<Pixel>(low - 1));
  const int at = count_at_most(sample, static_cast<Pixel>(low)) - below;
  return low - 0.5 + (at > 0 ? (wanted - below) / at : 0.5);
}

template <class Pixel>
TECNOGAMMA_INLINE TileLight light_of(const Sample<Pixel>& sample) {
  const double upper = quantile(sample, kUpper, std::numeric_limits<Pixel>::max());
  const auto most = static_cast<Pixel>(
      std::clamp<double>(upper + 1, 0, static_cast<double>(std::numeric_limits<Pixel>::max())));
  const double lower = quantile(sample, kLower, most);
  TileLight light;
  light.noise = std::max(0.0, upper - lower) / kUpperAboveLower;
  light.background = upper + kUpperBelowMedian * light.noise;
  light.measured = true;
  return light;
}

TECNOGAMMA_VECTOR_CLONES TileLight measure_sample(const Sample<std::uint8_t>& sample) {
  return light_of(sample);
}

TECNOGAMMA_VECTOR_CLONES TileLight measure_sample(const Sample<std::uint16_t>& sample) {
  return light_of(sample);
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
  if (!light_[index].measured) light_[index] = measure(band, tile);
  return light_[index];
}

template <class Pixel>
TileLight Background<Pixel>::measure(int band, int tile) const {
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
  return measure_sample(sample);
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
