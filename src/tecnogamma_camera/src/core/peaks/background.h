// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "tecnogamma_camera/image_view.h"

namespace tecnogamma_camera {

/// The pixels of a tile without the laser: median and scatter, from two low quantiles, which a line
/// through the tile does not affect.
struct TileLight {
  double background = 0;  //!< [grey value] in the tile's middle
  double noise = 0;       //!< [grey value] standard deviation
  double down = 0;        //!< [grey values/px] rise of the background from row to row
};

/// Straight line through the background near a column.
struct BackgroundLine {
  double value = 0;  //!< [grey value] at that column
  double slope = 0;  //!< [grey values/px]
};

/// The light of a frame besides the laser: dark offset, ambient light and its gradient. It is
/// measured in tiles of about kTileColumns x kBandRows pixels, of which four rows are sampled. A
/// tile is measured when it is first needed.
template <class Pixel>
class Background {
 public:
  static constexpr int kTileColumns = 128;  //!< [px] chosen
  static constexpr int kBandRows = 128;     //!< [px] chosen

  explicit Background(const ImageView<Pixel>& image);

  int tiles() const { return tiles_; }
  int tile_of(int column) const { return column * tiles_ / image_.columns; }
  /// If the light rises from tile to tile, across or down, the rise is removed from the tile's
  /// noise.
  const TileLight& tile(int row, int tile);

  /// The background near a column: the line through the middles of its tile and of the next one on
  /// its side, or of the last two.
  BackgroundLine about(int row, int column);

 private:
  struct Tile {
    std::optional<TileLight> level;  // taken for level
    std::optional<TileLight> light;
  };

  Tile& at(int band, int tile) {
    return measured_[static_cast<std::size_t>(band) * static_cast<std::size_t>(tiles_) +
                     static_cast<std::size_t>(tile)];
  }
  int first_column_of(int tile) const { return (tile * image_.columns + tiles_ - 1) / tiles_; }
  double middle_row_of(int band) const {
    const int first = band * kBandRows;
    return 0.5 * (first + std::min(first + kBandRows, image_.rows) - 1);
  }
  const TileLight& as_level(int band, int tile);
  TileLight without_climb(int band, int tile);
  double slope_across(int band, int tile);
  double slope_down(int band, int tile);
  TileLight measure(int band, int tile, double across, double down, const TileLight& guess) const;

  ImageView<Pixel> image_;
  int tiles_;
  int bands_;
  std::vector<double> middles_;  // [px] of tiles
  TileLight last_;               // measured
  std::vector<Tile> measured_;
};

extern template class Background<std::uint8_t>;
extern template class Background<std::uint16_t>;

}  // namespace tecnogamma_camera
