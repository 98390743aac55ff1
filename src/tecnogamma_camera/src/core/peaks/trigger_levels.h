// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "peaks/background.h"
#include "peaks/lit_pixels.h"
#include "tecnogamma_camera/peak_detector.h"

namespace tecnogamma_camera {

/// The levels above which pixels of a row are lit, and how much light makes a spot.
///
/// Automatic: kNoiseSigmas of the noise above the background, at least kMinDistance, for each 64
/// columns of some rows. Where the background climbs within them, the level is above its highest
/// corner. Of the 3 million pixels of a frame, hundreds are above the level by chance, and now and
/// then `permanence` of them in a row. The light of a spot above the background must therefore also
/// be kSpotSigmas of its own noise, which is the pixel's noise times the root of the spot's width.
template <class Pixel>
class TriggerLevels {
 public:
  TriggerLevels(int columns, int trigger_level)
      : automatic_(trigger_level == kAutomaticLevel),
        columns_(columns),
        levels_(static_cast<std::size_t>(levels_of(columns)),
                static_cast<Pixel>(std::min(std::max(trigger_level, 0), kMost))) {}

  /// Sets automatic levels for some rows of a band, from their background.
  void follow(Background<Pixel>& background, int first_row, int rows) {
    if (first_row % Background<Pixel>::kBandRows == 0) measure(background, first_row);
    const int row = first_row + rows / 2;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      const Place& place = places_[i];
      const double level =
          place.level + place.down * (row - row_of_places_) + 0.5 * rows * std::abs(place.down);
      levels_[i] = static_cast<Pixel>(std::clamp<double>(level, 0, kMost));
    }
  }

  /// One for each kLevelColumns.
  const std::vector<Pixel>& levels() const { return levels_; }
  Pixel at(int column) const { return levels_[static_cast<std::size_t>(column / kLevelColumns)]; }

  /// Whether a spot is so narrow that its light has to be checked. A wider one has enough light if
  /// all of its pixels are above the level. A given level needs no check.
  bool may_be_noise(int width) const {
    return automatic_ && kSpotSigmas * kSpotSigmas > kNoiseSigmas * kNoiseSigmas * width;
  }

  /// Whether a lone lit pixel is too bright for noise.
  bool is_hot(Pixel grey, int column) const {
    return automatic_ &&
           grey - at(column) > kHotDistances * places_[column / kLevelColumns].distance;
  }

  /// @param light sum of a spot's grey values above the level
  bool is_enough(std::int64_t light, int column, int width) const {
    return static_cast<double>(light) >=
           places_[column / kLevelColumns].distance *
               (kSpotSigmas / kNoiseSigmas * std::sqrt(width) - width);
  }

 private:
  /// The background of kLevelColumns in a band, from which their level is computed.
  struct Place {
    double level;     // [grey value] in row_of_places_
    double distance;  // [grey values] of it above the background
    double down;      // [grey values/px] climb from row to row
  };

  void measure(Background<Pixel>& background, int first_row) {
    places_.clear();
    row_of_places_ = first_row;
    for (int first = 0; first < columns_; first += kLevelColumns) {
      const int middle = std::min(first + kLevelColumns / 2, columns_ - 1);
      const int tile = background.tile_of(middle);
      const BackgroundLine line = background.about(first_row, middle);
      const double climb = 0.5 * kLevelColumns * std::abs(line.slope);
      const double above = distance(background, first_row, tile);
      places_.push_back({line.value + climb + above, above, background.tile(first_row, tile).down});
    }
  }

  /// Distance of the level from the background. The noise is the tile's own, or the mean with its
  /// neighbours if that is higher: the tile's own may have come out too low.
  static double distance(Background<Pixel>& background, int row, int tile) {
    const int first = std::max(0, tile - 1);
    const int end = std::min(background.tiles(), tile + 2);
    double sum = 0;
    for (int i = first; i < end; ++i)
      sum += background.tile(row, i).noise;
    const double noise = std::max(background.tile(row, tile).noise, sum / (end - first));
    return std::max(kNoiseSigmas * noise, kMinDistance);
  }

  static constexpr int kMost = std::numeric_limits<Pixel>::max();  // [grey value]
  static constexpr double kNoiseSigmas = 3.5;                      // chosen
  static constexpr double kSpotSigmas = 6;                         // chosen
  static constexpr double kHotDistances = 3;  // of the level above the background; chosen
  static constexpr double kMinDistance = 3;   // [grey values] chosen

  bool automatic_;
  int columns_;
  std::vector<Pixel> levels_;
  std::vector<Place> places_;  // of automatic levels
  int row_of_places_ = 0;
};

}  // namespace tecnogamma_camera
