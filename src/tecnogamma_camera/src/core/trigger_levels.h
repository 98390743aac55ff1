// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "background.h"
#include "tecnogamma_camera/peak_detector.h"

namespace tecnogamma_camera {

/// Above what the pixels of each tile in a row are lit, and how much light makes a spot.
///
/// Automatic: kNoiseSigmas of the noise above the background, at least kLeastDistance. Of the 3
/// million pixels of a frame hundreds are above it by chance, and now and then `permanence` of them
/// in a row: so the light of a spot above the background must be kSpotSigmas of its own noise as
/// well, that is of the pixel's noise times the root of its width.
template <class Pixel>
class TriggerLevels {
 public:
  TriggerLevels(int columns, int trigger_level)
      : automatic_(trigger_level == kAutomaticLevel),
        levels_(static_cast<std::size_t>(tiles_in(columns)),
                static_cast<Pixel>(std::min<int>(std::max(trigger_level, 0), kMost))),
        distances_(levels_.size()) {}

  /// Automatic ones, from the row's background.
  void follow(Background<Pixel>& background, int row) {
    for (int tile = 0; tile < static_cast<int>(levels_.size()); ++tile) {
      const double distance = std::max(kNoiseSigmas * noise(background, row, tile), kLeastDistance);
      const double level = background.tile(row, tile).background + distance;
      distances_[tile] = distance;
      levels_[tile] = static_cast<Pixel>(std::clamp<double>(level, 0, kMost));
    }
  }

  const std::vector<Pixel>& of_tiles() const { return levels_; }
  Pixel at(int column) const { return levels_[static_cast<std::size_t>(column / kTileColumns)]; }

  /// Whether a spot is so narrow that its light has to be looked at: in a wider one all pixels
  /// above the level are enough. A level that was given is taken at its word.
  bool may_be_noise(int width) const {
    return automatic_ && kSpotSigmas * kSpotSigmas > kNoiseSigmas * kNoiseSigmas * width;
  }

  /// @param light sum of a spot's grey values above the level
  bool is_enough(std::int64_t light, int column, int width) const {
    const double distance = distances_[static_cast<std::size_t>(column / kTileColumns)];
    return static_cast<double>(light) >=
           distance * (kSpotSigmas / kNoiseSigmas * std::sqrt(width) - width);
  }

 private:
  /// A tile's own or, against the chance that it came out too low, the mean with its neighbours'.
  double noise(Background<Pixel>& background, int row, int tile) const {
    const int first = std::max(0, tile - 1);
    const int end = std::min(static_cast<int>(levels_.size()), tile + 2);
    double sum = 0;
    for (int i = first; i < end; ++i)
      sum += background.tile(row, i).noise;
    return std::max(background.tile(row, tile).noise, sum / (end - first));
  }

  static constexpr int kMost = std::numeric_limits<Pixel>::max();
  static constexpr double kNoiseSigmas = 3.5;
  static constexpr double kSpotSigmas = 6;
  static constexpr double kLeastDistance = 3;  // [grey values]

  bool automatic_;
  std::vector<Pixel> levels_;
  std::vector<double> distances_;  // [grey values] of automatic levels above the background
};

}  // namespace tecnogamma_camera
